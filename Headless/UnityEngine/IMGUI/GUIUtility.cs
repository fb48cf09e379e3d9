namespace UnityEngine;

public class GUIUtility
{
    public static int hotControl { get; set; }
    public static int keyboardControl { get; set; }
    public static string systemCopyBuffer { get; set; } = "";
}
