using Headless.Bench.Scene;
using NUnit.Framework;

namespace Headless.Tests.Bench;

/// <summary>An earlier scene.csv that a run is compared with.</summary>
public sealed class SceneTableTests
{
    // Texts of drivers hold commas and quotes, before the numbers and behind them; cells may be empty.
    [Test]
    public void TimesAreThoseOfTheirColumnsWhateverTheTextsHold()
    {
        string file = Path.GetTempFileName();
        try
        {
            File.WriteAllLines(file,
            [
                "table,device,phase,build,commit,solver_ms,surface_ms,drawing_ms,date,driver",
                "scene,\"A \"\"fast\"\" one, with 2 cores\",0-1,this,,1.5,0,3,2026-11-28,\"Driver 1, of 2\"",
                "scene,\"A \"\"fast\"\" one, with 2 cores\",0-1,against,,7,8,9,2026-11-28,",
                "scene,llvmpipe,4-5,this,ab12,2,4,6,2026-11-28,",
            ]);
            Assert.That(SceneTable.Read(file), Is.EquivalentTo(new Dictionary<string, (double, double, double)> { ["0-1"] = (1.5, 0, 3), ["4-5"] = (2, 4, 6) }));
        }
        finally
        {
            File.Delete(file);
        }
    }
}
