using System.Text;

namespace Headless.Player.Output;

/// <summary>Files that have their name only when they are whole: written beside it, under the name with an ending, and then moved.</summary>
public static class WholeFile
{
    /// <summary>Of a file that is being written.</summary>
    public const string Ending = ".part";

    /// <exception cref="IOException">It cannot be written; nothing is left of the attempt, and what had the name before stays.</exception>
    public static void Write(string path, Action<Stream> write)
    {
        string partial = path + Ending;
        FileStream stream = File.Create(partial);
        try
        {
            using (stream) write(stream);
            File.Move(partial, path, overwrite: true);
        }
        catch
        {
            File.Delete(partial);
            throw;
        }
    }

    /// <inheritdoc cref="Write"/>
    public static void WriteText(string path, string text) => Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(text)));

    /// <summary>Deletes a file, and what is there of one that is being written.</summary>
    public static void Delete(string path)
    {
        File.Delete(path);
        File.Delete(path + Ending);
    }
}
