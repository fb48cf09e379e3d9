namespace SphFluid
{
    /// <summary>A number that an instrument reads.</summary>
    public readonly struct FluidReading
    {
        /// <summary>Name in a table, with the unit: <c>pressure_pa</c>.</summary>
        public readonly string Column;

        /// <summary>Unit as people write it: Pa.</summary>
        public readonly string Unit;

        /// <summary>The number, in that unit; not a number while nothing has been read.</summary>
        public readonly double Value;

        /// <summary>A reading.</summary>
        /// <param name="column">Name in a table, with the unit.</param>
        /// <param name="unit">Unit as people write it.</param>
        /// <param name="value">The number.</param>
        public FluidReading(string column, string unit, double value)
        {
            Column = column;
            Unit = unit;
            Value = value;
        }
    }
}
