package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

/** What every command takes, and the configuration file. */
class GlobalOptionsTest {
    private static final String[] SHORT_RUN = {"run", "clv", "--boats", "2", "--locations", "2", "--area", "60"};

    @TempDir
    Path folder;

    @Test
    void quietRunTellsNothingBesideItsReport() {
        CommandResult ran = crw(Map.of(), "--quiet", "--speed", "max");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).contains("outcome             ended");
        assertThat(ran.err()).isEmpty();
    }

    @Test
    void quietCommandTellsWhatIsWrong() throws Exception {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{\"formatVersion\": 99}");

        assertThat(CommandResult.crw("run", "nowhere", "--quiet").err()).startsWith("crw: there is no file");
        assertThat(CommandResult.crw("run", broken.toString(), "--quiet").err()).contains("error E-VERSION");
    }

    @Test
    void verboseCommandTellsItsVersionAndWhereAFaultArose() {
        CommandResult ran = CommandResult.crw("check", "clv", "--verbose");

        assertThat(ran.err()).startsWith("crw: crw ").contains("Java " + System.getProperty("java.version"));
        assertThat(CommandResult.crw("check", "clv", "--verbose", "--quiet").exitCode())
                .isEqualTo(2);
    }

    @Test
    void logFileGetsWhatIsToldOnStandardErrorAndIsAppendedTo() throws Exception {
        Path log = Files.writeString(folder.resolve("crw.log"), "before\n");

        CommandResult ran = crw(Map.of(), "--speed", "max", "--log-file", log.toString());
        CommandResult.crw("check", "nowhere", "--quiet", "--log-file", log.toString());

        assertThat(ran.err()).contains("running clv");
        assertThat(Files.readString(log))
                .startsWith("before\n")
                .containsPattern("(?m)^\\d{4}-\\d\\d-\\d\\dT\\S+Z running clv: boats 2")
                .containsPattern("(?m)Z crw: there is no file and no plan of the library 'nowhere'");
        assertThat(CommandResult.crw("check", "clv", "--log-file", "/dev/null/log")
                        .err())
                .contains("--log-file: /dev/null/log cannot be written");
    }

    @Test
    void configurationFileSetsOptionsAndTheCommandLineComesFirst() throws Exception {
        Path own = folder.resolve("sami/crw.properties");
        Files.createDirectories(own.getParent());
        Files.writeString(own, "run.speed = max\nseed = 7\nplans.json = true\n");
        Map<String, String> environment = Map.of("XDG_CONFIG_HOME", folder.toString());

        assertThat(crw(environment, "--json").out()).contains("\"seed\" : 7");
        assertThat(crw(environment, "--json", "--seed", "8").out()).contains("\"seed\" : 8");
        assertThat(execute(environment, "plans").out()).startsWith("{");
        assertThat(execute(environment, "check", "clv").out()).isEqualTo("clv: 0 errors, 0 warnings\n");
    }

    @ParameterizedTest
    @ValueSource(strings = {"run.bots", "bots", "sail.boats", "help"})
    void nameThatIsNoOptionIsRefused(String name) throws Exception {
        Path file = Files.writeString(folder.resolve("crw.properties"), "seed = 1\n" + name + " = 3\n");

        CommandResult ran = execute(Map.of(), "check", "clv", "--config", file.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.out()).isEmpty();
        assertThat(ran.err()).startsWith("crw: " + file + ": '" + name + "' is no option");
    }

    @Test
    void configurationFileThatIsNotThereIsNamed() {
        CommandResult ran = execute(Map.of(), "check", "clv", "--config=" + folder.resolve("nowhere"));

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--config: " + folder.resolve("nowhere"), "is not there");
    }

    @ParameterizedTest
    @ValueSource(strings = {"bash", "zsh"})
    void completionKnowsEveryCommand(String shell) {
        CommandResult ran = CommandResult.crw("completion", shell);

        assertThat(ran.exitCode()).isZero();
        Crw.commandLine()
                .getSubcommands()
                .keySet()
                .forEach(command -> assertThat(ran.out()).contains(command));
        assertThat(ran.out()).contains("--speed").startsWith(shell.equals("zsh") ? "autoload" : "#!/usr/bin/env bash");
    }

    /** A short run with options of its own. */
    private static CommandResult crw(Map<String, String> environment, String... more) {
        String[] all =
                Stream.concat(Arrays.stream(SHORT_RUN), Arrays.stream(more)).toArray(String[]::new);
        return execute(environment, all);
    }

    private static CommandResult execute(Map<String, String> environment, String... arguments) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        CommandLine line = Crw.commandLine().setOut(new PrintWriter(out)).setErr(new PrintWriter(err));
        return new CommandResult(Crw.execute(line, environment, arguments), out.toString(), err.toString());
    }
}
