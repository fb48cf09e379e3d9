namespace SphFluid.Validation
{
    /// <summary>
    /// Pressure at four gauges in the wall that a dam break hits, as two solvers have it with 400 particles over the water's height: in two
    /// dimensions, without air and friction. Water of 1.2 × 0.6 m, the wall 5.366 water's heights from the closed end, gauges of 8.4 mm.
    /// <para>J. J. De Courcy, T. C. S. Rendall, L. Constantin, B. Titurus, J. E. Cooper 2024, Incompressible δ-SPH via artificial
    /// compressibility, Comput. Methods Appl. Mech. Eng. 420, 116700, doi:10.1016/j.cma.2023.116700, as TrixiParticles.jl read it off the
    /// figure (validation/dam_break_2d/decourcy_pressure_sensor_P1.csv to P4, MIT licence, at a720b1d). The second solver is
    /// TrixiParticles.jl's own δ-SPH at c = 20 √(gH), validation_reference_wcsph_400.json there. Both in means over 0.05 √(H/g), of which
    /// there are 76.</para>
    /// </summary>
    public static class ConvergedPressure
    {
        /// <summary>Height of the water [m].</summary>
        public const double WaterHeight = 0.6;

        /// <summary>Distance of the wall from the closed end [m].</summary>
        public const double TankLength = 5.366 * WaterHeight;

        /// <summary>Edge of a gauge [m].</summary>
        public const double GaugeSize = 0.0084;

        /// <summary>Beginning of the first mean, and length of each, in √(H/g).</summary>
        public const double Start = 2.2, Interval = 0.05;

        /// <summary>Heights of the gauges' middles over the water's.</summary>
        public static readonly double[] Gauges = { 6.0 / 600.0, 30.0 / 600.0, 60.0 / 600.0, 160.0 / 600.0 };

        /// <summary>De Courcy and others, p/(ρ g H), a gauge and mean each.</summary>
        public static readonly double[][] Pressures =
        {
            Thousandths(
                0, 0, 0, 371, 2500, 2393, 2217, 2149, 2022, 1916, 1788, 1703, 1597, 1510, 1424, 1357, 1301, 1223, 1223, 1184, 1165, 1157,
                1143, 1132, 1117, 1105, 1091, 1097, 1083, 1076, 1069, 1063, 1054, 1048, 1040, 1014, 1024, 1017, 992, 1004, 995, 985, 980,
                960, 966, 937, 940, 916, 909, 899, 898, 887, 896, 883, 876, 858, 879, 873, 867, 860, 825, 830, 827, 836, 829, 802, 812,
                798, 787, 785, 786, 784, 799, 782, 765, 782),
            Thousandths(
                0, 0, 0, -117, 760, 1641, 1781, 1769, 1733, 1694, 1619, 1530, 1450, 1373, 1301, 1256, 1193, 1153, 1112, 1095, 1081, 1057,
                1048, 1048, 1040, 1028, 1025, 1013, 995, 997, 995, 986, 979, 973, 958, 960, 954, 947, 931, 918, 920, 906, 897, 893, 884,
                883, 876, 869, 855, 856, 845, 848, 827, 828, 815, 828, 813, 800, 792, 803, 797, 775, 766, 780, 773, 756, 748, 750, 738,
                746, 737, 734, 736, 732, 745, 733),
            Thousandths(
                0, 0, 0, -10, -31, 204, 698, 956, 1119, 1213, 1247, 1221, 1176, 1125, 1081, 1049, 987, 964, 932, 928, 899, 900, 883, 884,
                884, 892, 879, 876, 863, 859, 864, 862, 864, 852, 850, 841, 841, 845, 824, 830, 825, 815, 809, 816, 802, 795, 794, 784,
                785, 770, 782, 767, 764, 759, 745, 744, 734, 730, 730, 732, 714, 714, 709, 707, 707, 696, 687, 688, 679, 680, 675, 677,
                682, 677, 680, 679),
            Thousandths(
                0, 0, 0, 0, 0, -21, -1, 13, 6, 11, 21, 65, 90, 119, 145, 165, 172, 185, 187, 196, 196, 206, 222, 222, 230, 248, 254, 255,
                271, 285, 293, 302, 312, 322, 325, 333, 353, 360, 365, 370, 389, 388, 404, 401, 409, 419, 423, 422, 432, 428, 439, 435,
                440, 441, 442, 441, 449, 447, 441, 450, 456, 449, 451, 450, 457, 459, 465, 456, 467, 471, 467, 476, 484, 487, 496, 512)
        };

        /// <summary>TrixiParticles.jl, p/(ρ g H), a gauge and mean each.</summary>
        public static readonly double[][] SecondSolver =
        {
            Thousandths(
                0, 0, 0, 1206, 2545, 2415, 2160, 2029, 1930, 1850, 1739, 1630, 1519, 1410, 1360, 1288, 1236, 1217, 1162, 1159, 1122,
                1121, 1109, 1093, 1090, 1065, 1070, 1056, 1036, 1041, 1032, 1018, 1008, 1005, 1000, 989, 980, 971, 965, 958, 951, 942,
                935, 929, 918, 912, 906, 899, 891, 885, 879, 871, 866, 853, 845, 845, 838, 832, 820, 813, 809, 809, 800, 784, 787, 787,
                775, 771, 765, 770, 763, 757, 760, 760, 755, 758),
            Thousandths(
                0, 0, 0, 54, 719, 1595, 1776, 1738, 1736, 1689, 1615, 1529, 1425, 1321, 1274, 1205, 1155, 1138, 1088, 1085, 1050, 1051,
                1040, 1026, 1024, 1002, 1007, 994, 976, 983, 976, 961, 952, 950, 946, 937, 929, 922, 915, 908, 902, 894, 888, 883, 873,
                867, 862, 855, 848, 842, 837, 829, 823, 811, 804, 803, 796, 791, 781, 775, 769, 769, 762, 746, 749, 749, 737, 733, 728,
                732, 726, 720, 723, 723, 718, 722),
            Thousandths(
                0, 0, 0, 7, 20, 176, 647, 941, 1137, 1240, 1267, 1247, 1184, 1113, 1075, 1021, 980, 963, 922, 923, 894, 897, 890, 882,
                886, 869, 875, 868, 856, 863, 861, 850, 847, 848, 847, 838, 833, 827, 825, 821, 818, 812, 807, 803, 795, 790, 786, 780,
                775, 770, 765, 759, 755, 745, 738, 738, 733, 727, 717, 712, 708, 707, 700, 686, 689, 691, 680, 677, 672, 677, 672, 667,
                671, 671, 667, 672),
            Thousandths(
                0, 0, 0, 0, 0, 23, 3, 4, 6, 18, 37, 70, 106, 138, 162, 176, 186, 194, 193, 202, 203, 210, 216, 223, 233, 239, 251, 259,
                268, 283, 292, 301, 312, 325, 336, 346, 355, 366, 375, 384, 392, 399, 405, 412, 417, 422, 428, 432, 435, 438, 441, 444,
                445, 445, 445, 450, 453, 450, 449, 450, 451, 454, 454, 450, 452, 459, 459, 458, 457, 468, 472, 472, 479, 487, 491, 500)
        };

        internal static double[] Thousandths(params int[] values)
        {
            var numbers = new double[values.Length];
            for (int i = 0; i < values.Length; i++) numbers[i] = 0.001 * values[i];
            return numbers;
        }
    }
}
