using System.Collections.Generic;

namespace UnityEditor;

public class SessionState
{
    static readonly Dictionary<string, object> s_Values = new();

    public static void SetBool(string key, bool value) => s_Values[key] = value;
    public static bool GetBool(string key, bool defaultValue) => s_Values.GetValueOrDefault(key) is bool value ? value : defaultValue;
    public static void EraseBool(string key) => s_Values.Remove(key);
    public static void SetInt(string key, int value) => s_Values[key] = value;
    public static int GetInt(string key, int defaultValue) => s_Values.GetValueOrDefault(key) is int value ? value : defaultValue;
    public static void EraseInt(string key) => s_Values.Remove(key);
    public static void SetFloat(string key, float value) => s_Values[key] = value;
    public static float GetFloat(string key, float defaultValue) => s_Values.GetValueOrDefault(key) is float value ? value : defaultValue;
    public static void EraseFloat(string key) => s_Values.Remove(key);
    public static void SetString(string key, string value) => s_Values[key] = value;
    public static string GetString(string key, string defaultValue) => s_Values.GetValueOrDefault(key) as string ?? defaultValue;
    public static void EraseString(string key) => s_Values.Remove(key);
}
