namespace SphFluid.Validation
{
    /// <summary>A measured error of a run.</summary>
    public readonly struct CaseError
    {
        /// <summary>An error.</summary>
        /// <param name="name">Name in tables, for instance "front, shifted RMS".</param>
        /// <param name="value">Value, a fraction unless the name has a unit; not a number when it could not be measured.</param>
        public CaseError(string name, double value)
        {
            Name = name;
            Value = value;
        }

        /// <summary>Name in tables.</summary>
        public string Name { get; }

        /// <summary>Value, a fraction unless the name has a unit.</summary>
        public double Value { get; }
    }
}
