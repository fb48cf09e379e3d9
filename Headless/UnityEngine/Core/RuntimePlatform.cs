namespace UnityEngine;

public enum RuntimePlatform
{
    OSXEditor = 0,
    OSXPlayer = 1,
    WindowsPlayer = 2,
    WindowsEditor = 7,
    IPhonePlayer = 8,
    Android = 11,
    LinuxPlayer = 13,
    LinuxEditor = 16,
    WebGLPlayer = 17,
    WSAPlayerX86 = 18,
    WSAPlayerX64 = 19,
    WSAPlayerARM = 20,
    PS4 = 25,
    XboxOne = 27,
    tvOS = 31,
    Switch = 32,
    PS5 = 38,
    LinuxServer = 43,
    WindowsServer = 44,
    OSXServer = 45,
}
