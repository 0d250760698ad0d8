package org.sami.architecture;

import static java.util.stream.Collectors.toList;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
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

    @Test
    void wrapperIsThePublishedOneAndHoldsGradleToItsSha256() throws Exception {
        byte[] jar = Files.readAllBytes(Path.of("gradle", "wrapper", "gradle-wrapper.jar"));

        assertThat(sha256(jar)).isEqualTo("cb0da6751c2b753a16ac168bb354870ebb1e162e9083f116729cec9c781156b8");
        assertThat(Files.readString(Path.of("gradle", "wrapper", "gradle-wrapper.properties")))
                .contains("distributionSha256Sum=a4b4158601f8636cdeeab09bd76afb640030bb5b144aafe261a5e8af027dc612");
    }

    /** The script runs as it is; only Maven is one that brings files of the test's. */
    @Test
    void gradleIsNotMadeOfAFileThatIsNotTheListedOne(@TempDir Path folder) throws Exception {
        Path maven = Files.writeString(folder.resolve("mvn"), """
            #!/bin/bash
            for a in "$@"; do case $a in -DoutputDirectory=*) out=${a#*=};; esac; done
            mkdir -p "$out"
            while read -r sum file; do echo other > "$out/$file"; done < tools/gradle-artifacts.sha256
            """);
        assertThat(maven.toFile().setExecutable(true)).isTrue();
        ProcessBuilder making = new ProcessBuilder("bash", "tools/bootstrap-gradle.sh").redirectErrorStream(true);
        making.environment().put("GRADLE_USER_HOME", folder.resolve("home").toString());
        making.environment().put("TMPDIR", folder.toString());
        making.environment().merge("PATH", folder.toString(), (old, first) -> first + ":" + old);

        Process process = making.start();
        String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(process.waitFor()).isEqualTo(1);
        assertThat(said).contains("gradle-api-8.8.jar: FAILED").contains("nothing was made");
        assertThat(folder.resolve("home")).doesNotExist();
    }

    @Test
    void everyLibraryIsHeldToItsSha256() throws IOException {
        String verified = Files.readString(Path.of("gradle", "verification-metadata.xml"));
        String catalog = Files.readString(Path.of("gradle", "libs.versions.toml"));
        Matcher named = Pattern.compile("module = \"([^:\"]+):([^\"]+)\", version\\.ref = \"([^\"]+)\"")
                .matcher(catalog);

        List<String> unverified = new ArrayList<>();
        int count = 0;
        while (named.find()) {
            count++;
            Matcher version = Pattern.compile("(?m)^" + Pattern.quote(named.group(3)) + " = \"([^\"]+)\"")
                    .matcher(catalog);
            assertThat(version.find()).as(named.group(3)).isTrue();
            String component = "<component group=\"" + named.group(1) + "\" name=\"" + named.group(2) + "\" version=\""
                    + version.group(1) + "\">";
            if (!verified.contains(component) && !named.group(2).endsWith("-bom")) {
                unverified.add(component);
            }
        }

        assertThat(count).isGreaterThan(30);
        assertThat(unverified).isEmpty();
    }

    private static String sha256(byte[] bytes) throws NoSuchAlgorithmException {
        return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(bytes));
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
    void checkRunsTheTestsThatAreTasksOfOtherNames() throws IOException {
        List<String> others = new ArrayList<>();
        for (Path file : buildFiles()) {
            String text = Files.readString(file);
            Matcher tasks =
                    Pattern.compile("tasks\\.register\\('(\\w+)', Test\\)").matcher(text);
            while (tasks.find()) {
                others.add(tasks.group(1));
                String task = file.equals(Path.of("build.gradle")) ? "test" : "check";
                assertThat(text)
                        .as(file.toString())
                        .containsPattern("tasks\\.named\\('" + task + "'\\) \\{[^}]*dependsOn " + tasks.group(1));
            }
        }

        assertThat(others).containsExactlyInAnyOrder("architectureTest", "longTest", "processTest", "windowTest");
    }

    @Test
    void modulesWithLongTestsRunThem() throws IOException {
        for (SamiModule module : SamiModule.built().toList()) {
            boolean hasLongTests = false;
            for (Path source : module.testSources()) {
                hasLongTests |= Files.readString(source).contains("\n@Tag(\"long\")\n");
            }

            assertThat(Files.readString(Path.of(module.toString(), "build.gradle"))
                            .contains("id 'sami.long-tests'"))
                    .as(module.toString())
                    .isEqualTo(hasLongTests);
        }
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
        List<Path> found = new ArrayList<>();
        try (Stream<Path> top = Files.list(Path.of(""))) {
            // Git makes and deletes files in its own folder meanwhile.
            for (Path one : top.filter(path -> !path.toString().startsWith(".")).toList()) {
                try (Stream<Path> all = Files.walk(one, 4)) {
                    all.filter(Files::isRegularFile)
                            .filter(path -> path.toString().endsWith(".gradle"))
                            .filter(path -> !path.toString().contains("build/"))
                            .forEach(found::add);
                }
            }
        }
        return found.stream().sorted().collect(toList());
    }
}
