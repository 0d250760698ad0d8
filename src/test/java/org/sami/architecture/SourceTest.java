package org.sami.architecture;

import static java.util.stream.Collectors.toCollection;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** What sources must and must not contain, read as text. */
class SourceTest {
    /** Plans are data: an engine or a handler that knows one by its id would treat it unlike the others. */
    private static final Pattern PLAN_ID = Pattern.compile("\\bclv\\b|station-keep");

    private static final Pattern SLEEP = Pattern.compile("Thread\\.sleep\\(|TimeUnit\\.\\w+\\.sleep\\(|System\\.gc\\(");

    @ParameterizedTest
    @EnumSource(SamiModule.class)
    void everyPackageSaysWhatBelongsThere(SamiModule module) {
        List<Path> sources = module.mainSources();
        SortedSet<Path> packages = sources.stream().map(Path::getParent).collect(toCollection(TreeSet::new));

        assertThat(packages)
                .isNotEmpty()
                .allSatisfy(folder ->
                        assertThat(folder.resolve("package-info.java")).exists());
    }

    @Test
    void languageKnowsNoPlanByItsId() {
        List<Path> sources = SamiModule.SPN_CORE.mainSources();

        assertThat(sources).hasSizeGreaterThan(100);
        assertThat(containing(PLAN_ID, sources)).isEmpty();
    }

    @Test
    void handlersKnowNoPlanByItsId() {
        List<Path> sources = SamiModule.CRW_DOMAIN.mainSources().stream()
                .filter(path -> path.toString().contains("/handler/"))
                .toList();

        assertThat(sources).isNotEmpty();
        assertThat(containing(PLAN_ID, sources)).isEmpty();
    }

    @Test
    void testsWaitForWhatHappensAndNeverSleep() {
        List<Path> tests = new ArrayList<>();
        Arrays.stream(SamiModule.values()).forEach(module -> tests.addAll(module.testSources()));

        assertThat(tests).isNotEmpty();
        assertThat(containing(SLEEP, tests)).isEmpty();
    }

    private static List<Path> containing(Pattern words, List<Path> sources) {
        return sources.stream().filter(source -> contains(words, source)).toList();
    }

    private static boolean contains(Pattern words, Path source) {
        try (Stream<String> lines = Files.lines(source)) {
            return lines.anyMatch(line -> words.matcher(line).find());
        } catch (IOException e) {
            throw new java.io.UncheckedIOException("cannot read " + source, e);
        }
    }
}
