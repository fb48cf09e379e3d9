using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>A row with a column of every kind; rows of the same name are of the same run.</summary>
    internal sealed class MadeUpRow : MeasuredRow
    {
        public static readonly TableFormat<MadeUpRow> Format = new TableFormat<MadeUpRow>("made-up.csv")
            .Text("name", r => r.Name, (r, v) => r.Name = v)
            .Number("speed_m_s", r => r.Speed, (r, v) => r.Speed = v)
            .Count("steps", r => r.Steps, (r, v) => r.Steps = v)
            .Flag("on", r => r.IsOn, (r, v) => r.IsOn = v, "yes", "no")
            .Text("device", r => r.Device, (r, v) => r.Device = v)
            .Text("date", r => r.Date, (r, v) => r.Date = v);

        public string Name = "";
        public double Speed;
        public long Steps;
        public bool IsOn;
        public bool IsEmpty;

        public override string Key => Name.Length > 0 ? Name : null;

        public override bool IsMeasured => !IsEmpty;
    }
}
