namespace Headless.Files;

/// <summary>
/// Reads text files whose content nobody vouches for: the size of a file and the length of a line are bounded, and what the
/// disk refuses is a message about the file.
/// </summary>
public static class BoundedText
{
    private const int MebiByte = 1 << 20;

    /// <summary>Largest file that is read whole [bytes]; in memory it takes twice that and its values some times more.</summary>
    public const int LargestFile = 64 * MebiByte;

    /// <exception cref="BadFileException">The file is missing, not a plain file, not readable or too large.</exception>
    public static string ReadAll(string path, int largest = LargestFile)
    {
        CheckSize(path, largest);
        return Guard(path, () =>
        {
            using var reader = new StreamReader(new MemoryStream(ReadPlain(path, largest)));
            return reader.ReadToEnd();
        });
    }

    /// <exception cref="BadFileException">As <see cref="ReadAll"/>.</exception>
    public static byte[] ReadBytes(string path, int largest = LargestFile)
    {
        CheckSize(path, largest);
        return Guard(path, () => ReadPlain(path, largest));
    }

    /// <summary>A reader that goes through a large file line by line; the caller disposes of it.</summary>
    /// <exception cref="BadFileException">As <see cref="ReadAll"/>.</exception>
    public static StreamReader Open(string path, long largest)
    {
        CheckSize(path, largest);
        return Guard(path, () => new StreamReader(path));
    }

    // A device has no length and no end.
    private static byte[] ReadPlain(string path, int largest)
    {
        using FileStream stream = File.OpenRead(path);
        if (!stream.CanSeek) throw new IOException("it is no plain file.");
        byte[] bytes = new byte[Math.Min(stream.Length, largest)];
        stream.ReadExactly(bytes);
        return bytes;
    }

    private static void CheckSize(string path, long largest)
    {
        var info = new FileInfo(path);
        bool plain = Guard(path, () => info.Exists && (info.Attributes & (FileAttributes.Directory | FileAttributes.Device)) == 0);
        if (!plain) throw new BadFileException($"{path}: not a file that can be read. Restore it, or remove what refers to it.");
        if (info.Length > largest)
        {
            throw new BadFileException(FormattableString.Invariant(
                $"{path}: the file has {info.Length / (double)MebiByte:0.#} MiB; at most {largest / MebiByte} MiB are read. Divide it, or move large data into files of their own."));
        }
    }

    private static T Guard<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw new BadFileException($"{path}: cannot be read: {e.Message}", e);
        }
    }
}
