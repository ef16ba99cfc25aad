// Solves a symmetric positive definite 6x6 system by LDL^T, unrolled: loops over arrays with computed indices go
// through memory on some drivers (six times slower on llvmpipe). The matrix is given by its lower triangle, row by row
// (m10 is row 1, column 0).
struct Lower6 {
  float m00;
  float m10, m11;
  float m20, m21, m22;
  float m30, m31, m32, m33;
  float m40, m41, m42, m43, m44;
  float m50, m51, m52, m53, m54, m55;
};

// Right-hand side and solution: components 0 to 2 in `top`, 3 to 5 in `bottom`.
void solve6(Lower6 m, inout vec3 top, inout vec3 bottom) {
  float i0 = 1.0 / (m.m00);
  float c10 = m.m10, l10 = c10 * i0;
  float i1 = 1.0 / (m.m11 - c10 * l10);
  float c20 = m.m20, l20 = c20 * i0;
  float c21 = m.m21 - c20 * l10, l21 = c21 * i1;
  float i2 = 1.0 / (m.m22 - c20 * l20 - c21 * l21);
  float c30 = m.m30, l30 = c30 * i0;
  float c31 = m.m31 - c30 * l10, l31 = c31 * i1;
  float c32 = m.m32 - c30 * l20 - c31 * l21, l32 = c32 * i2;
  float i3 = 1.0 / (m.m33 - c30 * l30 - c31 * l31 - c32 * l32);
  float c40 = m.m40, l40 = c40 * i0;
  float c41 = m.m41 - c40 * l10, l41 = c41 * i1;
  float c42 = m.m42 - c40 * l20 - c41 * l21, l42 = c42 * i2;
  float c43 = m.m43 - c40 * l30 - c41 * l31 - c42 * l32, l43 = c43 * i3;
  float i4 = 1.0 / (m.m44 - c40 * l40 - c41 * l41 - c42 * l42 - c43 * l43);
  float c50 = m.m50, l50 = c50 * i0;
  float c51 = m.m51 - c50 * l10, l51 = c51 * i1;
  float c52 = m.m52 - c50 * l20 - c51 * l21, l52 = c52 * i2;
  float c53 = m.m53 - c50 * l30 - c51 * l31 - c52 * l32, l53 = c53 * i3;
  float c54 = m.m54 - c50 * l40 - c51 * l41 - c52 * l42 - c53 * l43, l54 = c54 * i4;
  float i5 = 1.0 / (m.m55 - c50 * l50 - c51 * l51 - c52 * l52 - c53 * l53 - c54 * l54);
  float y0 = top.x;
  float y1 = top.y - l10 * y0;
  float y2 = top.z - l20 * y0 - l21 * y1;
  float y3 = bottom.x - l30 * y0 - l31 * y1 - l32 * y2;
  float y4 = bottom.y - l40 * y0 - l41 * y1 - l42 * y2 - l43 * y3;
  float y5 = bottom.z - l50 * y0 - l51 * y1 - l52 * y2 - l53 * y3 - l54 * y4;
  float x5 = y5 * i5;
  float x4 = y4 * i4 - l54 * x5;
  float x3 = y3 * i3 - l43 * x4 - l53 * x5;
  float x2 = y2 * i2 - l32 * x3 - l42 * x4 - l52 * x5;
  float x1 = y1 * i1 - l21 * x2 - l31 * x3 - l41 * x4 - l51 * x5;
  float x0 = y0 * i0 - l10 * x1 - l20 * x2 - l30 * x3 - l40 * x4 - l50 * x5;
  top = vec3(x0, x1, x2);
  bottom = vec3(x3, x4, x5);
}
