namespace Headless.Checks.Documents.Facts;

/// <summary><c>picture:fountain</c> is its caption, `COMMAND` on DEVICE, DAY; <c>picture:fountain:date</c>, <c>command</c>, <c>device</c>, <c>moments</c> and <c>particles</c> are parts of it.</summary>
internal sealed class PictureFacts
{
    private readonly Dictionary<string, PictureRecord> records;
    private readonly string project;

    public PictureFacts(ProjectPackages packages)
    {
        project = packages.Project;
        records = PictureRecord.Folders(packages).SelectMany(PictureRecord.Read).DistinctBy(r => r.Name).ToDictionary(r => r.Name);
    }

    public IEnumerable<PictureRecord> All => records.Values;

    public PictureRecord Of(string name) => records.TryGetValue(name, out var record) ? record : throw new UnknownFactException($"no {PictureRecord.TableName} has a picture '{name}'");

    public string Find(string[] words)
    {
        if (words.Length == 0) throw new UnknownFactException("which picture");
        var record = Of(words[0]);
        return words.Length == 1 ? Caption(record) : words[1] switch
        {
            "command" => $"`{record.Command}`",
            "date" => Date(record),
            "device" => FactText.Device(record.Device),
            "moments" => record.Times,
            "particles" => FactText.Number(double.Parse(record.Particles, System.Globalization.CultureInfo.InvariantCulture)),
            _ => throw new UnknownFactException($"a picture has no {words[1]}"),
        };
    }

    private string Caption(PictureRecord record) => $"`{record.Command}` on {FactText.Device(record.Device)}, {Date(record)}";

    // A chart is of the days of its table.
    private string Date(PictureRecord record) => record.Data.Length > 0
        ? FactText.Dates(CsvTable.Read(Path.Combine(project, record.Data)).Rows.Select(r => r["date"]))
        : record.Date;
}
