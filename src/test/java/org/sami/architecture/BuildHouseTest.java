package org.sami.architecture;

import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What keeps the build working on both kinds of machines (docs/decisions/0001). */
class BuildHouseTest {
    @Test
    void wrapperSeesToItsDistributionFirst() throws IOException {
        String gradlew = Files.readString(Path.of("gradlew"));

        assertThat(gradlew).contains("\"$APP_HOME/tools/ensure-gradle.sh\" \"$JAVACMD\" \"$CLASSPATH\" || exit");
    }

    @Test
    void everyScriptMeansTheSameGradle() throws IOException {
        String properties = Files.readString(Path.of("gradle", "wrapper", "gradle-wrapper.properties"));
        Matcher distribution =
                Pattern.compile("gradle-(\\d+\\.\\d+(?:\\.\\d+)?)-bin").matcher(properties);

        assertThat(distribution.find()).isTrue();
        String version = distribution.group(1);
        assertThat(Files.readString(Path.of("tools", "ensure-gradle.sh"))).contains("gradle-" + version + "-bin");
        assertThat(Files.readString(Path.of("tools", "bootstrap-gradle.sh"))).contains("V=" + version + "\n");
    }

    /** Gradle itself breaks on a later Java, with a stack trace and before any build file is read. */
    @ParameterizedTest
    @CsvSource({"1.8.0_402", "11.0.2", "23.0.1", "25.0.3"})
    void javaThatGradleCannotRunOnIsRefusedInOneLineBeforeGradleStarts(String version, @TempDir Path folder)
            throws Exception {
        Path java = Files.writeString(
                folder.resolve("java"), "#!/bin/sh\necho 'openjdk version \"" + version + "\"' >&2\n");
        assertThat(java.toFile().setExecutable(true)).isTrue();

        Process checked = new ProcessBuilder("tools/ensure-gradle.sh", java.toString(), "wrapper.jar")
                .redirectErrorStream(true)
                .start();
        String said = new String(checked.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(checked.waitFor()).isEqualTo(1);
        assertThat(said)
                .startsWith("SAMI is built with JDK 17")
                .contains(java.toString())
                .contains("JAVA_HOME");
        assertThat(said.lines()).hasSize(2);
    }

    @Test
    void testOfTheWholeRunsTheTasksOfOtherNames() throws IOException {
        List<String> others = new ArrayList<>();
        for (Path file : buildFiles()) {
            Matcher tasks =
                    Pattern.compile("tasks\\.register\\('(\\w+)', Test\\)").matcher(Files.readString(file));
            while (tasks.find()) {
                others.add(tasks.group(1));
            }
        }
        Matcher gathered = Pattern.compile("tasks\\.named\\('test'\\) \\{[^}]*dependsOn ([^}]*)}")
                .matcher(Files.readString(Path.of("build.gradle")));

        assertThat(others).containsExactlyInAnyOrder("architectureTest", "processTest", "windowTest");
        assertThat(gathered.find()).isTrue();
        assertThat(gathered.group(1)).contains(others);
    }

    /** Who logs where is for an application to say; a library that brings a binding says it for all. */
    @Test
    void onlyApplicationsBindALogger() throws IOException {
        for (Path file : buildFiles()) {
            String text = Files.readString(file);
            boolean binds = Pattern.compile("(?m)^\\s*(api|implementation|runtimeOnly)\\b.*slf4j")
                    .matcher(text)
                    .find();

            assertThat(binds).as(file.toString()).isEqualTo(file.endsWith("sami.program.gradle"));
        }
    }

    @Test
    void buildFilesNameNoRepositoryButMavenCentral() throws IOException {
        List<Path> files = buildFiles();

        assertThat(files).hasSizeGreaterThanOrEqualTo((int) SamiModule.built().count() + 4);
        for (Path file : files) {
            assertThat(Files.readString(file))
                    .as(file.toString())
                    .doesNotContain("gradlePluginPortal", "jcenter", "google()", "mavenLocal", "url ", "url=");
        }
    }

    private static List<Path> buildFiles() throws IOException {
        try (Stream<Path> all = Files.walk(Path.of(""), 5)) {
            return all.filter(Files::isRegularFile)
                    .filter(path -> path.toString().endsWith(".gradle"))
                    .filter(path -> !path.toString().contains("build/"))
                    .sorted()
                    .collect(toList());
        }
    }
}
