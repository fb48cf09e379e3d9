using Headless.Help;

// sphhelp PROJECT: writes the texts of ./run --help.
if (args is not [var project] || !Directory.Exists(Path.Combine(project, "Headless")))
{
    Console.Error.WriteLine("help: the one word is the project's folder.");
    return 2;
}
string[] stale = [.. HelpFiles.Stale(project)];
HelpFiles.Write(project);
Console.WriteLine(stale.Length == 0 ? $"{HelpFiles.Folder} is as the tables have it." : $"{HelpFiles.Folder}: written anew: {string.Join(", ", stale)}");
return 0;
