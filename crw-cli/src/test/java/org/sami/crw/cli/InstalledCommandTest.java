package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.IntNode;
import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.server.testing.Await;

/** The command as it is installed, started by its script, in processes of its own. */
@Tag("process")
class InstalledCommandTest {
    private static final Path INSTALLED = CrwProcess.INSTALLED;
    private static final String JAVA = System.getProperty("java.home");
    private static final long LIMIT_S = 240;

    @TempDir
    Path folder;

    private Path cache;

    @BeforeEach
    void makeACache() {
        cache = folder.resolve("cache");
    }

    @Test
    void commandTakesItsClassesFromTheArchiveOfTheBuild() throws Exception {
        assertThat(ownClassesFromArchive(INSTALLED)).isGreaterThan(350);
        assertThat(cache).doesNotExist();
    }

    @Test
    void anotherJavaThanTheBuildsGetsAnArchiveOfItsOwn() throws Exception {
        Path install = copyOfTheInstall();
        Files.delete(install.resolve("lib/crw.jsa.release"));

        CommandResult first = crw(install, Map.of(), "check", "clv");
        Await.until("an archive", LIMIT_S, () -> archives() == 1);

        assertThat(first.exitCode()).as(first.err()).isZero();
        assertThat(first.err()).isEmpty();
        assertThat(ownClassesFromArchive(install)).isGreaterThan(350);
    }

    @Test
    void commandWorksWhereNothingCanBeWritten() throws Exception {
        Path install = copyOfTheInstall();
        Files.delete(install.resolve("lib/crw.jsa"));
        Files.delete(install.resolve("lib/crw.jsa.release"));
        cache = Path.of("/dev/null/cache");

        CommandResult ran = crw(install, Map.of(), "check", "clv");

        assertThat(ran).isEqualTo(new CommandResult(0, "clv: 0 errors, 0 warnings\n", ""));
    }

    /** Java 17 built it; the Javas are those that lie next to that one. */
    @ParameterizedTest(allowZeroInvocations = true)
    @MethodSource("otherJavas")
    void commandRunsAlikeOnEveryOtherJavaFrom17To25OfThisMachine(Path java) throws Exception {
        String[] mission = {"run", "clv", "--boats", "2", "--locations", "4", "--speed", "max", "--json"};

        CommandResult ran = crw(INSTALLED, Map.of("JAVA_HOME", java.toString()), mission);

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.err()).doesNotContainIgnoringCase("warning");
        assertThat(new ObjectMapper().readTree(ran.out()).path("runHash"))
                .isEqualTo(new ObjectMapper()
                        .readTree(CommandResult.crw(mission).out())
                        .path("runHash"));
    }

    static List<Path> otherJavas() throws IOException {
        Path thisOne = Path.of(JAVA).toRealPath();
        List<Path> others = new ArrayList<>();
        try (Stream<Path> beside = Files.list(thisOne.getParent())) {
            for (Path java :
                    beside.filter(each -> !Files.isSymbolicLink(each)).sorted().toList()) {
                if (!java.equals(thisOne) && Files.isExecutable(java.resolve("bin/java")) && isFrom17To25(java)) {
                    others.add(java);
                }
            }
        }
        return others;
    }

    private static boolean isFrom17To25(Path java) throws IOException {
        Matcher version = Pattern.compile("JAVA_VERSION=\"(\\d+)").matcher(Files.readString(java.resolve("release")));
        return version.find() && Integer.parseInt(version.group(1)) >= 17 && Integer.parseInt(version.group(1)) <= 25;
    }

    @Test
    void damagedArchiveIsPassedOver() throws Exception {
        Path install = copyOfTheInstall();
        Files.delete(install.resolve("lib/crw.jsa"));
        Files.writeString(install.resolve("lib/crw.jsa"), "no archive");

        CommandResult ran = crw(install, Map.of(), "check", "clv");

        assertThat(ran).isEqualTo(new CommandResult(0, "clv: 0 errors, 0 warnings\n", ""));
    }

    @Test
    void archiveThatDoesNotFitIsPassedOverWithoutAWordInTheOutput() throws Exception {
        Path install = copyOfTheInstall();
        try (Stream<Path> files = Files.list(install.resolve("lib"))) {
            for (Path jar :
                    files.filter(file -> file.toString().endsWith(".jar")).toList()) {
                Files.setLastModifiedTime(jar, FileTime.from(Instant.EPOCH));
            }
        }

        CommandResult ran = crw(install, Map.of(), "check", "clv", "--json");

        assertThat(ran.err()).isEmpty();
        assertThat(new ObjectMapper().readTree(ran.out()).path("errors")).isEqualTo(IntNode.valueOf(0));
    }

    @Test
    void namesOutsideAsciiAreReadAndPrintedWithoutALocale() throws Exception {
        Path project = Files.createDirectories(folder.resolve("\u00dcbung")).resolve("pl\u00e4n.json");
        Files.writeString(
                project, "{\"formatVersion\": 1, \"id\": \"x\", \"name\": \"x\", \"domain\": \"W\u00e4sser\"}");

        CommandResult ran = crw(INSTALLED, Map.of("LC_ALL", "C"), "check", project.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains(project.toString()).contains("W\u00e4sser");
    }

    @Test
    void processWithoutTheScriptPrintsUtf8WithoutALocale() throws Exception {
        Path project = folder.resolve("plan.json");
        Files.writeString(
                project, "{\"formatVersion\": 1, \"id\": \"x\", \"name\": \"x\", \"domain\": \"W\u00e4sser\"}");
        List<String> command = List.of(
                Path.of(JAVA, "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                Crw.class.getName(),
                "check",
                project.toString());

        assertThat(run(command, Map.of("LC_ALL", "C")).out()).contains("W\u00e4sser");
    }

    @Test
    void optionsForJavaReachIt() throws Exception {
        CommandResult ran = crw(INSTALLED, Map.of("JAVA_OPTS", "-Dcrw.trace=true -showversion"), "--version");

        assertThat(ran.err()).contains(System.getProperty("java.version"));
        assertThat(ran.out()).startsWith("crw ");
    }

    @Test
    void bashThatLoadedTheScriptCompletesCommandsAndTheirOptions() throws Exception {
        assumeTrue(Files.isExecutable(Path.of("/bin/bash")), "there is no /bin/bash here");
        Path script = Files.writeString(
                folder.resolve("completion.bash"),
                crw(INSTALLED, Map.of(), "completion", "bash").out());

        assertThat(completed(script, "che")).containsExactly("check");
        assertThat(completed(script, "check", "--js")).containsExactly("--json");
    }

    /** What bash offers for the last of the words after {@code crw}, by the function that the script registered; compopt works only at a prompt. */
    private List<String> completed(Path script, String... words) throws Exception {
        String function = "$(complete -p crw | sed 's/.*-F \\([^ ]*\\).*/\\1/')";
        String commands = "compopt() { :; }; source " + script + "; COMP_WORDS=(crw " + String.join(" ", words)
                + "); COMP_CWORD=" + words.length + "; " + function + "; printf '%s\\n' \"${COMPREPLY[@]}\"";
        CommandResult ran = run(List.of("/bin/bash", "--norc", "-c", commands), Map.of());
        assertThat(ran.err()).isEmpty();
        return ran.out().lines().map(String::strip).toList();
    }

    private long ownClassesFromArchive(Path install) throws Exception {
        Path log = folder.resolve("classes.log");
        CommandResult ran = crw(install, Map.of("JAVA_OPTS", "-Xlog:class+load:file=" + log), "check", "clv");
        assertThat(ran).isEqualTo(new CommandResult(0, "clv: 0 errors, 0 warnings\n", ""));
        try (Stream<String> lines = Files.lines(log)) {
            return lines.filter(line -> line.contains(" org.sami.") && line.endsWith("shared objects file"))
                    .count();
        }
    }

    private long archives() {
        try (Stream<Path> files = Files.list(cache.resolve("sami"))) {
            return files.filter(file -> file.toString().endsWith(".jsa")).count();
        } catch (IOException e) {
            return 0;
        }
    }

    /** Time stamps stay, for an archive is good only for the files that it was made of. */
    private Path copyOfTheInstall() throws Exception {
        Path copy = folder.resolve("copy");
        CommandResult ran = run(List.of("cp", "-pR", INSTALLED.toString(), copy.toString()), Map.of());
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        return copy;
    }

    private CommandResult crw(Path install, Map<String, String> environment, String... arguments) throws Exception {
        List<String> command =
                new ArrayList<>(List.of(install.resolve("bin/crw").toString()));
        command.addAll(List.of(arguments));
        return run(command, environment);
    }

    private CommandResult run(List<String> command, Map<String, String> environment) throws Exception {
        File out = folder.resolve("out").toFile();
        File err = folder.resolve("err").toFile();
        ProcessBuilder builder = new ProcessBuilder(command).redirectOutput(out).redirectError(err);
        CrwProcess.prepare(builder.environment(), folder);
        builder.environment().put("XDG_CACHE_HOME", cache.toString());
        builder.environment().putAll(environment);
        Process process = builder.start();
        try {
            assertThat(process.waitFor(LIMIT_S, TimeUnit.SECONDS)).as("it ends").isTrue();
        } finally {
            process.destroyForcibly();
        }
        return new CommandResult(
                process.exitValue(),
                Files.readString(out.toPath(), StandardCharsets.UTF_8),
                Files.readString(err.toPath(), StandardCharsets.UTF_8));
    }
}
