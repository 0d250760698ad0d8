package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is said of command lines that make no sense, and how help looks. */
class UsageTest {
    @TempDir
    Path folder;

    static List<List<String>> wrong() {
        return List.of(
                List.of("Which command", ""),
                List.of("'dance'", "dance"),
                List.of("--fast", "run clv --fast"),
                List.of("--boats is 1 to 250, not 0", "run clv --boats 0"),
                List.of("--boats is 1 to 250, not 251", "run clv --boats 251"),
                List.of("expected is a whole number, not 'many'", "run clv --boats many"),
                List.of("--locations is 1 to 10000, not 0", "run clv --locations 0"),
                List.of("--area is 10 to 20000, not 5", "run clv --area 5"),
                List.of("'--area': expected is a number, not 'wide'", "run clv --area wide"),
                List.of("a speed is 'max' or a number above 0", "run clv --speed fast"),
                List.of("--speed", "run clv --speed 0"),
                List.of("--for", "run clv --for soon"),
                List.of("--answer-after", "run clv --answer-after -1"),
                List.of("expected is a whole number, not 'x'", "run clv --seed x"),
                List.of("for option '--set'", "run clv --set nonsense"),
                List.of("--journal: there is no folder", "run clv --journal no-such-folder/clv.journal"),
                List.of("no parameter 'depth'; it has", "run clv --set depth=3"),
                List.of("expected is a number such as 2.5", "run station-keep --set ask-stations.spacing=wide"),
                List.of("the library has clv, station-keep", "run clw"),
                List.of("there is no file 'none.json'", "run none.json"),
                List.of("--plan: clv has no plan 'x'; it has clv", "run clv --plan x"),
                List.of("--answers: cannot read none.json", "run clv --answers none.json"),
                List.of("'alarm' does not say when", "run station-keep --interrupt alarm"),
                List.of("no interrupt 'alarm'; it has End station keeping", "run station-keep --interrupt alarm@5"),
                List.of("the plan has no interrupt 'alarm'; it has none", "run clv --interrupt alarm@5"),
                List.of("'soon' is no number of seconds", "run clv --interrupt alarm@soon"),
                List.of("'--current': expected is a speed in m/s, @ and a direction", "run clv --current 0.3"),
                List.of("a flow has a speed of 0 to 50 m/s", "run clv --wind 99@0"),
                List.of("there is no sensor 'salt'; there are temperature", "run clv --sensor salt"),
                List.of("the GPS noise in metres is 0 to 100.0, not 101.0", "run clv --gps-noise 101"),
                List.of("each kind of sensor is there once", "run clv --sensor ph --sensor ph@2"),
                List.of("at most 20.0 m/s, not 21.0", "boat --port 0 --name a --at 45,10 --top-speed 21"),
                List.of("0 to 90", "boat --port 0 --name a --at 45,10 --compass-noise 91"),
                List.of("PLAN|FILE", "run"),
                List.of("FILE|PLAN", "check"),
                List.of("JOURNAL", "resume"),
                List.of("there is no journal none.journal", "resume none.journal"),
                List.of("there is no journal none.journal", "journal none.journal"),
                List.of("there is no file", "check none.json"));
    }

    @ParameterizedTest
    @MethodSource("wrong")
    void wrongUsageIsNamedAndNothingIsPrinted(List<String> caseOf) {
        String line = caseOf.get(1);

        CommandResult ran = CommandResult.crw(line.isEmpty() ? new String[0] : line.split(" "));

        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(2);
        assertThat(ran.err()).contains(caseOf.get(0)).doesNotContain("Exception");
        assertThat(ran.out()).isEmpty();
    }

    @Test
    void journalThatIsThereIsNotOverwritten() throws Exception {
        Path journal = Files.writeString(folder.resolve("old.journal"), "precious");

        CommandResult ran = CommandResult.crw("run", "clv", "--journal", journal.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("is there already").contains("crw resume " + journal);
        assertThat(journal).hasContent("precious");
    }

    @Test
    void reportThatCouldNotBeWrittenIsRefusedBeforeAnythingRuns() throws Exception {
        Path file = Files.writeString(folder.resolve("report"), "a file");
        Path journal = folder.resolve("run.journal");

        CommandResult ran =
                CommandResult.crw("run", "clv", "--report", file.toString(), "--journal", journal.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("--report: " + file).doesNotContain("running");
        assertThat(journal).doesNotExist();
    }

    @Test
    void fileThatIsNoJournalIsRefused() throws Exception {
        Path file = Files.writeString(folder.resolve("text"), "not a journal");

        CommandResult ran = CommandResult.crw("resume", file.toString());

        assertThat(ran.exitCode()).isEqualTo(4);
        assertThat(ran.err()).contains(file.toString()).doesNotContain("\tat ");
        assertThat(file).hasContent("not a journal");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "\"OperatorAprove\", \"answer\": {\"yes\": true}|2:22|/rules/0/event|is OperatorApprove meant?",
                "\"OperatorCreateLocations\", \"answer\": {\"values\": {\"location\": []}}|2:83|/rules/0/answer/values/location|is locations meant?",
                "\"OperatorApprove\", \"answr\": {\"yes\": true}|2:50|/rules/0/answr|is answer meant?",
                "\"OperatorApprove\", \"answer\": {\"yes\": true,}|2:64|the top|Unexpected",
            })
    void faultOfAnAnswersFileHasItsPlaceAndWhatWasProbablyMeant(String rule, String at, String pointer, String words)
            throws Exception {
        Path answers = Files.writeString(
                folder.resolve("answers.json"),
                "{\"format\": \"crw-answers\", \"version\": 1, \"rules\": [\n           {\"event\": " + rule + "}]}");

        CommandResult ran = CommandResult.crw("run", "clv", "--answers", answers.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err())
                .contains(answers + ":" + at + ": error E-")
                .contains(" at " + pointer)
                .contains(words);
    }

    @ParameterizedTest
    @ValueSource(strings = {"plans", "check", "run", "resume", "journal", "demo"})
    void helpOfEveryCommandHasExamples(String command) {
        CommandResult ran = CommandResult.crw(command, "--help");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("Usage: crw " + command)
                .contains("Example")
                .contains("crw " + command);
        assertThat(ran.err()).isEmpty();
    }

    @Test
    void helpOfTheWholeListsCommandsAndExitCodes() {
        CommandResult ran = CommandResult.crw("--help");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .contains("plans", "check", "run", "resume", "demo")
                .contains("Exit codes:", "3", "aborted")
                .contains("Examples:");
    }

    @Test
    void whatTheListSaysOfACommandIsWholeSentences() {
        String help = CommandResult.crw("--help").out();

        String list = help.substring(help.indexOf("Commands:\n"), help.indexOf("Exit codes:"));
        String[] entries = list.substring(list.indexOf('\n')).strip().split("\n  (?=[a-z])");
        assertThat(entries).hasSizeGreaterThan(20).allMatch(entry -> entry.endsWith("."));
    }

    @Test
    void runsHelpNamesEveryOptionWithItsDefault() {
        String help = CommandResult.crw("run", "--help").out();

        assertThat(help)
                .contains("--boats", "--locations", "--area", "--seed", "--speed", "--for", "--set", "--answer-after")
                .contains("--answers", "--report", "--journal", "--json", "--plan")
                .contains("--gps-noise", "--compass-noise", "--current", "--wind", "--sensor")
                .contains("default 3", "default 12", "default 600", "default 1", "default 20", "default 5");
    }

    @Test
    void versionSaysWhatItRunsOn() {
        CommandResult ran = CommandResult.crw("--version");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out()).startsWith("crw ").contains("Java 1");
    }
}
