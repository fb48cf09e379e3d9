namespace SphFluid.Validation
{
    /// <summary>
    /// MARIN's dam break against a box (SPHERIC test case 2): pressures on the box. Kleefsman, K.M.T. et al. (2005), J. Comput. Phys. 206,
    /// 363-393, doi:10.1016/j.jcp.2004.12.007; places of the gauges: Issa, R. and Violeau, D. (2006), SPHERIC test case 2, release 1.1,
    /// figure 7. Means over 50 ms and over the four gauges of a face, rounded to 10 Pa, of the record that AQUAgpusph carries
    /// (examples/3D/spheric_testcase2_dambreak, 7,395 samples). P1 to P4 are on the middle of the face that the water hits, 21, 61, 101 and
    /// 141 mm above the floor; P5 to P8 on the middle of the top, as far behind that face's edge.
    /// <para>A mean over 50 ms has no peak: P1 reached 11.2 kPa for a millisecond, and 9.1 kPa in the mean of the same 50 ms.</para>
    /// </summary>
    public static class MarinPressures
    {
        /// <summary>Length of the means [s]; the first is from zero on.</summary>
        public const double Interval = 0.05;

        /// <summary>Mean of P1 to P4 [Pa], 0 to 6 s.</summary>
        public static readonly double[] Front = Pascals(
            -2, -3, -3, -3, -3, -3, -3, 10, 442, 648, 548, 477, 393, 362, 359, 353, 336, 339, 318, 296,
            285, 285, 275, 252, 261, 244, 215, 211, 225, 221, 217, 220, 222, 226, 228, 240, 238, 232, 238, 239,
            242, 240, 241, 232, 229, 226, 221, 213, 211, 202, 195, 186, 180, 171, 161, 155, 147, 139, 134, 130,
            124, 115, 116, 116, 111, 110, 113, 111, 110, 109, 107, 101, 98, 94, 89, 83, 81, 78, 72, 71,
            69, 67, 67, 65, 63, 63, 63, 58, 52, 49, 48, 53, 67, 103, 158, 191, 202, 196, 189, 181,
            175, 170, 166, 161, 158, 156, 149, 141, 140, 137, 133, 136, 140, 139, 141, 145, 145, 143, 145, 146);

        /// <summary>Mean of P5 to P8 [Pa], 0 to 6 s.</summary>
        public static readonly double[] Top = Pascals(
            1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 2,
            4, 6, 9, 1, 24, 43, 19, 49, 84, 102, 129, 150, 168, 158, 178, 174, 169, 171, 170, 166,
            167, 165, 166, 162, 159, 156, 152, 146, 141, 136, 132, 127, 118, 110, 99, 87, 75, 64, 58, 58,
            53, 47, 40, 37, 36, 36, 35, 36, 34, 33, 32, 31, 31, 27, 23, 18, 12, 7, 6, 4,
            1, -2, -2, -2, -3, -4, -3, -1, -1, -2, -2, -2, -3, -3, -2, -2, -2, 1, 19, 35,
            44, 48, 48, 55, 54, 53, 49, 41, 35, 32, 31, 30, 33, 36, 44, 52, 57, 71, 86, 97);

        private static double[] Pascals(params int[] tens)
        {
            var pascals = new double[tens.Length];
            for (int i = 0; i < tens.Length; i++) pascals[i] = 10.0 * tens[i];
            return pascals;
        }
    }
}
