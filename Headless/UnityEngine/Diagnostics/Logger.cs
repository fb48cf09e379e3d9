using System;
using System.Globalization;

namespace UnityEngine;

public class Logger : ILogger
{
    public Logger(ILogHandler logHandler)
    {
        this.logHandler = logHandler;
        logEnabled = true;
        filterLogType = LogType.Log;
    }

    public ILogHandler logHandler { get; set; }
    public bool logEnabled { get; set; }
    public LogType filterLogType { get; set; }

    // Exceptions always pass unless logging is off; otherwise a lower number is more severe.
    public bool IsLogTypeAllowed(LogType logType) =>
        logEnabled && (logType == LogType.Exception || (filterLogType != LogType.Exception && logType <= filterLogType));

    public void Log(LogType logType, object message) => Send(logType, null, message, null);
    public void Log(LogType logType, object message, Object context) => Send(logType, null, message, context);
    public void Log(LogType logType, string tag, object message) => Send(logType, tag, message, null);
    public void Log(LogType logType, string tag, object message, Object context) => Send(logType, tag, message, context);
    public void Log(object message) => Send(LogType.Log, null, message, null);
    public void Log(string tag, object message) => Send(LogType.Log, tag, message, null);
    public void Log(string tag, object message, Object context) => Send(LogType.Log, tag, message, context);
    public void LogWarning(string tag, object message) => Send(LogType.Warning, tag, message, null);
    public void LogWarning(string tag, object message, Object context) => Send(LogType.Warning, tag, message, context);
    public void LogError(string tag, object message) => Send(LogType.Error, tag, message, null);
    public void LogError(string tag, object message, Object context) => Send(LogType.Error, tag, message, context);

    public void LogFormat(LogType logType, string format, params object?[] args) => LogFormat(logType, null, format, args);

    public void LogFormat(LogType logType, Object? context, string format, params object?[] args)
    {
        if (IsLogTypeAllowed(logType)) logHandler.LogFormat(logType, context, format, args);
    }

    public void LogException(Exception exception) => LogException(exception, null);

    public void LogException(Exception exception, Object? context)
    {
        if (logEnabled) logHandler.LogException(exception, context);
    }

    void Send(LogType logType, string? tag, object? message, Object? context)
    {
        if (!IsLogTypeAllowed(logType)) return;
        string text = message switch
        {
            null => "Null",
            IFormattable formattable => formattable.ToString(null, CultureInfo.InvariantCulture),
            _ => message.ToString() ?? "",
        };
        if (tag is null) logHandler.LogFormat(logType, context, "{0}", text);
        else logHandler.LogFormat(logType, context, "{0}: {1}", tag, text);
    }
}
