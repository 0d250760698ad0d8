package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class ReadMessagesTest {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/mavlink");
    private static final Pattern IMPORT = Pattern.compile("import io\\.dronefleet\\.mavlink\\.[\\w.]+\\.(\\w+);");
    private static final Pattern LOOKS_AT = Pattern.compile("instanceof (\\w+)");

    @Test
    void eachKindThatSomeClassOfTheBaseLooksAtIsRead() throws Exception {
        Set<String> lookedAt = new TreeSet<>();
        for (String part : List.of("base", "vehicle", "command", "mission", "param")) {
            lookedAt.addAll(lookedAt(SOURCES.resolve(part)));
        }
        lookedAt.remove("CommandLong"); // the base's own is looked at before it is sent

        assertThat(ReadMessages.KINDS.stream().map(Class::getSimpleName).collect(Collectors.toSet()))
                .isEqualTo(lookedAt);
    }

    private static Set<String> lookedAt(Path folder) throws IOException {
        Set<String> all = new TreeSet<>();
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : files.toList()) {
                String source = Files.readString(file);
                Set<String> imported = found(IMPORT, source);
                found(LOOKS_AT, source).stream().filter(imported::contains).forEach(all::add);
            }
        }
        return all;
    }

    private static Set<String> found(Pattern pattern, String source) {
        Set<String> words = new TreeSet<>();
        Matcher matcher = pattern.matcher(source);
        while (matcher.find()) {
            words.add(matcher.group(1));
        }
        return words;
    }
}
