package org.sami.crw.cli.defaults;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/** Defaults by subject, as tables for a terminal or for a page. */
final class DefaultsText {
    private DefaultsText() {}

    /** A table for each subject; what a value does and where it is set stand below it where lines would be too long. */
    static String plain(List<DefaultValue> values) {
        StringBuilder text = new StringBuilder();
        int names = widest(values, DefaultValue::name);
        int amounts = Math.min(24, widest(values, DefaultValue::valueText));
        bySubject(values).forEach((subject, rows) -> {
            text.append(text.isEmpty() ? "" : "\n").append(subject).append('\n');
            rows.forEach(row -> text.append("  ")
                    .append(padded(row.name(), names))
                    .append("  ")
                    .append(padded(row.valueText(), amounts))
                    .append("  ")
                    .append(row.meaning())
                    .append(row.setBy().equals(DefaultValue.NOWHERE) ? "" : " [" + row.setBy() + "]")
                    .append('\n'));
        });
        return text.append(
                        "\nIn brackets: where it is set. Others are constants of the program. A configuration file sets options: docs/command-line.md.\n")
                .toString();
    }

    /** A heading and a Markdown table for each subject. */
    static String markdown(List<DefaultValue> values) {
        StringBuilder text = new StringBuilder();
        bySubject(values).forEach((subject, rows) -> {
            text.append(text.isEmpty() ? "" : "\n")
                    .append("## ")
                    .append(subject)
                    .append("\n\n| name | value | what it does | set by |\n|---|---|---|---|\n");
            rows.forEach(row -> text.append("| ")
                    .append(cell(row.name()))
                    .append(" | ")
                    .append(cell(row.valueText()))
                    .append(" | ")
                    .append(cell(row.meaning()))
                    .append(" | ")
                    .append(cell(row.setBy()))
                    .append(" |\n"));
        });
        return text.toString();
    }

    private static String cell(String text) {
        return text.replace("|", "\\|").replace("<", "\\<").replace("*", "\\*");
    }

    private static Map<String, List<DefaultValue>> bySubject(List<DefaultValue> values) {
        return values.stream()
                .collect(Collectors.groupingBy(DefaultValue::subject, LinkedHashMap::new, Collectors.toList()));
    }

    private static int widest(List<DefaultValue> values, java.util.function.Function<DefaultValue, String> text) {
        return values.stream()
                .mapToInt(value -> text.apply(value).length())
                .max()
                .orElse(0);
    }

    private static String padded(String text, int width) {
        return text + " ".repeat(Math.max(0, width - text.length()));
    }
}
