using System.Text;

namespace UnityEngine;

public class TextAsset : Object
{
    readonly byte[] m_Bytes;

    public TextAsset() : this("") { }
    public TextAsset(string text) => m_Bytes = Encoding.UTF8.GetBytes(text ?? "");
    internal TextAsset(byte[] bytes) => m_Bytes = bytes;

    public byte[] bytes => (byte[])m_Bytes.Clone();
    public long dataSize => m_Bytes.Length;

    public string text
    {
        get
        {
            int skip = m_Bytes.Length >= 3 && m_Bytes[0] == 0xEF && m_Bytes[1] == 0xBB && m_Bytes[2] == 0xBF ? 3 : 0;
            return Encoding.UTF8.GetString(m_Bytes, skip, m_Bytes.Length - skip);
        }
    }

    public override string ToString() => text;

    internal override Object CloneNative() => new TextAsset(bytes) { name = name };
}
