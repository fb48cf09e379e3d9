using System;

namespace SphFluid
{
    /// <summary>The unit that inspectors write after a field's name.</summary>
    [AttributeUsage(AttributeTargets.Field)]
    internal sealed class UnitAttribute : Attribute
    {
        /// <param name="symbol">The unit's symbol, e.g. "kg/m³".</param>
        public UnitAttribute(string symbol) => Symbol = symbol;

        /// <summary>The unit's symbol.</summary>
        public string Symbol { get; }
    }
}
