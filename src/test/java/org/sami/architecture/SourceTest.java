package org.sami.architecture;

import static java.util.stream.Collectors.toCollection;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What sources must and must not contain, read as text. */
class SourceTest {
    /** Plans are data: an engine or a handler that knows one by its id would treat it unlike the others. */
    private static final Pattern PLAN_ID = Pattern.compile("\\bclv\\b|station-keep");

    private static final Pattern PUBLIC_TYPE =
            Pattern.compile("public (?:[\\w-]+ )*?(?:class|interface|enum|record|@interface) .*");

    private static final Pattern SLEEP = Pattern.compile("Thread\\.sleep\\(|TimeUnit\\.\\w+\\.sleep\\(|System\\.gc\\(");

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void everyPackageSaysWhatBelongsThere(SamiModule module) {
        List<Path> sources = module.mainSources();
        SortedSet<Path> packages = sources.stream().map(Path::getParent).collect(toCollection(TreeSet::new));

        assertThat(packages)
                .isNotEmpty()
                .allSatisfy(folder ->
                        assertThat(folder.resolve("package-info.java")).exists());
    }

    @ParameterizedTest
    @MethodSource("org.sami.architecture.SamiModule#built")
    void everyPublicTypeSaysWhatItIs(SamiModule module) throws IOException {
        List<Path> silent = new ArrayList<>();
        int types = 0;
        for (Path source : module.mainSources()) {
            List<String> lines = Files.readAllLines(source);
            int type = firstPublicType(lines);
            if (type >= 0) {
                types++;
                if (!javadocStandsBefore(type, lines)) {
                    silent.add(source);
                }
            }
        }

        assertThat(types).as("public types seen in %s", module).isPositive();
        assertThat(silent).isEmpty();
    }

    @Test
    void languageKnowsNoPlanByItsId() {
        List<Path> sources = Stream.of(SamiModule.SPN_LANGUAGE, SamiModule.SPN_CORE, SamiModule.SPN_AUTHORING)
                .flatMap(module -> module.mainSources().stream())
                .toList();

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

    /** The task that runs them has a process for each class of such a name, and for no other. */
    @Test
    void testsOfARealWindowAreKnownByTheirNames() throws IOException {
        List<String> names = new ArrayList<>();
        for (SamiModule module : SamiModule.built().toList()) {
            for (Path test : module.testSources()) {
                if (Files.readString(test).contains("@Tag(\"window\")")) {
                    names.add(test.getFileName().toString());
                }
            }
        }

        assertThat(names).hasSizeGreaterThan(10).allMatch(name -> name.endsWith("WindowTest.java"));
    }

    @Test
    void testsWaitForWhatHappensAndNeverSleep() {
        List<Path> tests = new ArrayList<>();
        SamiModule.built().forEach(module -> tests.addAll(module.testSources()));

        assertThat(tests).isNotEmpty();
        assertThat(containing(SLEEP, tests)).isEmpty();
    }

    private static int firstPublicType(List<String> lines) {
        for (int i = 0; i < lines.size(); i++) {
            if (PUBLIC_TYPE.matcher(lines.get(i)).matches()) {
                return i;
            }
        }
        return -1;
    }

    private static boolean javadocStandsBefore(int type, List<String> lines) {
        int line = type - 1;
        while (line > 0 && !lines.get(line).endsWith("*/") && !lines.get(line).isBlank()) {
            line--; // annotations, which may take several lines
        }
        return line >= 0 && lines.get(line).endsWith("*/");
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
