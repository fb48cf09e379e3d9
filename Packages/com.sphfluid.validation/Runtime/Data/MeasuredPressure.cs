using static SphFluid.Validation.ConvergedPressure;

namespace SphFluid.Validation
{
    /// <summary>
    /// Pressure that experiments measured at the gauges of <see cref="ConvergedPressure"/>, in means over 0.1 √(H/g), of which there are
    /// 38. They have what those solutions leave out: a gate, air, walls on both sides and friction.
    /// <para>At 6, 60 and 160 mm in 600: L. Lobovský, E. Botia-Vera, F. Castellana, J. Mas-Soler, A. Souto-Iglesias 2014, Experimental
    /// investigation of dynamic pressure loads during dam break, J. Fluids Struct. 48, 407-434, doi:10.1016/j.jfluidstructs.2014.03.009;
    /// water of 0.6 × 0.3 m, wall at 1.61 m, gauges of 4.2 mm at 3, 30 and 80 mm; as PySPH read it off the figures
    /// (pysph/examples/db_exp_data.py, BSD licence).</para>
    /// <para>At 160 mm also: B. Buchner 2002, Green Water on Ship-type Offshore Structures, thesis, Delft University of Technology; water
    /// of 1.2 × 0.6 m, a gauge of 90 mm in diameter; as TrixiParticles.jl read it off the figure
    /// (validation/dam_break_2d/exp_pressure_sensor_P1.csv, there until 62ac80f; MIT licence).</para>
    /// </summary>
    public static class MeasuredPressure
    {
        /// <summary>Length of each mean in √(H/g); the first begins at <see cref="ConvergedPressure.Start"/>.</summary>
        public const double Interval = 0.1;

        /// <summary>Experiments at each of <see cref="ConvergedPressure.Gauges"/>, p/(ρ g H); none at the second.</summary>
        public static readonly double[][][] Experiments =
        {
            new[]
            {
                Thousandths(
                    13, 13, 1642, 1958, 1650, 1362, 1173, 1035, 926, 844, 782, 742, 713, 695, 696, 701, 669, 635, 608, 581, 558, 557, 553,
                    538, 552, 578, 597, 598, 578, 554, 534, 540, 554, 575, 599, 641, 740, 862)
            },
            System.Array.Empty<double[]>(),
            new[]
            {
                Thousandths(
                    7, 7, 17, 571, 1419, 1510, 1459, 1285, 1111, 882, 705, 630, 610, 577, 574, 588, 571, 594, 545, 544, 586, 600, 583, 639,
                    614, 564, 584, 604, 593, 589, 573, 580, 593, 604, 626, 652, 730, 869)
            },
            new[]
            {
                Thousandths(
                    2, 2, 5, 11, 7, 81, 206, 364, 445, 491, 524, 539, 557, 575, 577, 561, 536, 546, 561, 565, 569, 574, 556, 507, 482, 483,
                    484, 483, 479, 470, 464, 465, 463, 463, 471, 490, 529, 698),
                Thousandths(
                    -4, -3, 47, 259, 534, 678, 670, 650, 605, 574, 547, 542, 543, 544, 542, 542, 543, 547, 555, 557, 557, 555, 551, 545,
                    540, 531, 516, 513, 514, 514, 522, 540, 552, 576, 619, 661, 807, 679)
            },
        };
    }
}
