package org.sami.crw.cli.defaults;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.Model.OptionSpec;

/** The defaults of the options of {@code crw}, as the options themselves have them. */
final class OptionValues {
    private static final Pattern SAID = Pattern.compile(" ?\\(default:? ([^;)]*?)(?:; ([^)]*))?\\)");
    private static final Pattern ELSEWHERE = Pattern.compile("likewise|that of --.*");
    private static final Map<String, String> UNITS =
            Map.of("SECONDS", "s", "METRES", "m", "PERCENT", "%", "MPS", "m/s", "DEGREES", "°");

    private OptionValues() {}

    /** Options that several commands have alike are one value. */
    static List<DefaultValue> of(CommandLine crw) {
        Map<DefaultValue, String> commands = new LinkedHashMap<>();
        crw.getSubcommands()
                .forEach((name, line) -> line.getCommandSpec()
                        .options()
                        .forEach(option -> value(option)
                                .ifPresent(value -> commands.merge(value, "crw " + name, (a, b) -> a + ", " + b))));
        return commands.entrySet().stream()
                .map(entry -> {
                    DefaultValue value = entry.getKey();
                    return new DefaultValue(
                            value.subject(),
                            value.name(),
                            value.value(),
                            value.unit(),
                            value.meaning(),
                            entry.getValue());
                })
                .toList();
    }

    private static Optional<DefaultValue> value(OptionSpec option) {
        String description =
                String.join(" ", option.description()).replace("%%", "%").replaceFirst(" Default: [^.]*\\.$", "");
        Matcher said = SAID.matcher(description);
        boolean isSaid = said.find();
        String value = Optional.ofNullable(option.defaultValue())
                .filter(given -> !given.isEmpty())
                .orElseGet(() -> isSaid && !ELSEWHERE.matcher(said.group(1)).matches() ? said.group(1) : "");
        if (value.isEmpty()) {
            return Optional.empty();
        }
        String meaning = isSaid
                ? said.replaceFirst(said.group(2) == null ? "" : " (" + Matcher.quoteReplacement(said.group(2)) + ")")
                : description;
        boolean isNumber = Character.isDigit(value.charAt(0)) && !value.contains(" ");
        return Optional.of(new DefaultValue(
                "Options of crw",
                option.longestName(),
                value,
                isNumber ? UNITS.getOrDefault(option.paramLabel(), "") : "",
                meaning,
                ""));
    }
}
