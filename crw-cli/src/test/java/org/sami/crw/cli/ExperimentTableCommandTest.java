package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.sami.crw.cli.CommandResult.crw;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The command {@code crw experiment --table}, and experiments of one's own. */
@Tag("long")
class ExperimentTableCommandTest {
    private static final String CELLS = "table.csv";

    @TempDir
    Path folder;

    private CommandResult table(String name, String out, String... more) {
        List<String> arguments = new ArrayList<>(List.of("experiment"));
        if (!name.isEmpty()) {
            arguments.addAll(List.of("--table", name));
        }
        arguments.addAll(List.of("--boats", "3", "--locations", "8", "--area", "150"));
        if (!List.of(more).contains("--repetitions")) {
            arguments.addAll(List.of("--repetitions", "2"));
        }
        if (!out.isEmpty()) {
            arguments.addAll(List.of("--out", folder.resolve(out).toString()));
        }
        arguments.addAll(List.of(more));
        return crw(arguments.toArray(new String[0]));
    }

    private double mean(String out, String column) throws IOException {
        return Files.readAllLines(folder.resolve(out).resolve(CELLS)).stream()
                .map(line -> line.replaceFirst("^\"[^\"]*\"", "").split(",", -1))
                .filter(cells -> cells[1].equals(column))
                .mapToDouble(cells -> Double.parseDouble(cells[7]))
                .findFirst()
                .orElseThrow();
    }

    /** The kept numbers are those of small areas; clicks follow from which locations are unvisited at an incident. */
    @ParameterizedTest
    @CsvSource({
        "7.1, --set swap=10 --range 600 --charge 50..60, 28, 10",
        "7.2, --set alarms=1 --alarm-length 10, 36, 4",
        "7.3, --set inside=2 --set side=90, 47, -3"
    })
    void cellOfEachTableHasTheGainThatWasKept(String name, String options, double clicks, double time)
            throws IOException {
        CommandResult ran = table(name, "kept", options.split(" "));

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(mean("kept", "# interactions")).isCloseTo(clicks, within(6.0));
        assertThat(mean("kept", "total time")).isCloseTo(time, within(12.0));
        assertThat(ran.out()).contains("Table " + name).contains("divide locations by auction");
    }

    /** Of 20 locations, as eight have five pull-outs, which are seldom all over before the mission is. */
    @Test
    void pullOutsHaveTheGainsThatWereKept() throws IOException {
        CommandResult ran = crw(
                "experiment",
                "--table",
                "7.4",
                "--boats",
                "3",
                "--locations",
                "20",
                "--area",
                "150",
                "--repetitions",
                "2",
                "--set",
                "swap=10",
                "--out",
                folder.resolve("kept").toString());

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(mean("kept", "# interactions")).isCloseTo(47, within(6.0));
        assertThat(mean("kept", "reassigning # interactions")).isCloseTo(62, within(6.0));
        assertThat(mean("kept", "total time")).isCloseTo(5, within(12.0));
    }

    /** Boats that drive to safety at twice their speed need less time, though not half of it: they turn and speed up in both versions. */
    @Test
    void markupShortensTheTimeInAHazard() throws IOException {
        CommandResult ran = table("8.1", "hazard", "--set", "side=70");

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        assertThat(mean("hazard", "hazard (-)")).isBetween(-50.0, -15.0);
        assertThat(mean("hazard", "time (-)")).isBetween(-15.0, 0.0);
        assertThat(mean("hazard", "G measurements")).isPositive();
        assertThat(mean("hazard", "flight alone: hazard (-)")).isCloseTo(mean("hazard", "hazard (-)"), within(3.0));
        assertThat(ran.out()).contains("Table 8.1", "-47 %", "safe place");
    }

    @Test
    void callWithFewerRepetitionsKeepsTheRowsOfTheEarlierOne() throws IOException {
        String[] two = {"--set", "alarms=1", "--alarm-length", "10"};
        table("7.2", "fewer", two);
        Path file = folder.resolve("fewer").resolve("runs.csv");
        String whole = Files.readString(file);

        CommandResult one = table("7.2", "fewer", "--repetitions", "1", "--set", "alarms=1", "--alarm-length", "10");

        assertThat(one.exitCode()).as(one.out() + one.err()).isZero();
        assertThat(file).hasContent(whole);
        assertThat(table("7.2", "fewer", two).err()).contains("6 runs", "6 of them were made earlier");
    }

    @Test
    void tableIsTheSameWithOneJobAndWithTwoAndGoesOnWhereItWasCut() throws IOException {
        String[] alarm = {"--set", "alarms=1", "--alarm-length", "10"};
        List<String> two = new ArrayList<>(List.of(alarm));
        two.addAll(List.of("--jobs", "2"));

        CommandResult alone = table("7.2", "alone", alarm);
        Files.createDirectories(folder.resolve("cut"));
        table("7.2", "cut", two.toArray(new String[0]));
        Path rows = folder.resolve("cut").resolve("runs.csv");
        String whole = Files.readString(rows);
        Files.writeString(rows, whole.substring(0, whole.length() - 90)); // as if it had been killed in its last row
        CommandResult goneOn = table("7.2", "cut", two.toArray(new String[0]));

        assertThat(goneOn.out()).isEqualTo(alone.out());
        assertThat(goneOn.err()).contains("3 of them were made earlier");
        for (String file : List.of("runs.csv", CELLS, "table.txt", "table.html")) {
            assertThat(folder.resolve("cut").resolve(file))
                    .as(file)
                    .hasSameTextualContentAs(folder.resolve("alone").resolve(file));
        }
        assertThat(folder.resolve("alone").resolve("table.png")).isNotEmptyFile();
    }

    @Test
    void repetitionThatDoesNotEndIsShownAndInNoMean() throws IOException {
        CommandResult ran = table("7.2", "late", "--set", "alarms=1", "--set", "limit=20");

        assertThat(ran.exitCode()).isEqualTo(6);
        assertThat(ran.out())
                .containsPattern("3, 8, 1 +- +- +- +0 +2 +0")
                .contains("3, 8, 1, repetition 1, standard: running, it did not end within 20 s: assemble goes on");
    }

    /** Without a swap of batteries no boat gets home: the run ends long before its limit of four hours. */
    @Test
    void runWhoseBatteriesAreEmptyEndsAndNamesTheBoats() {
        CommandResult ran = table("7.2", "", "--set", "alarms=1", "--range", "120", "--repetitions", "1");

        assertThat(ran.out()).containsPattern("repetition 1, .*: failed, empty battery: boat[123]");
        assertThat(ran.out()).doesNotContain("did not end within");
    }

    @Test
    void folderOfOtherSettingsIsNotMixedUp() throws IOException {
        Path out = Files.createDirectories(folder.resolve("other"));
        Files.writeString(out.resolve("runs.csv"), "configuration\n");

        CommandResult ran = table("7.2", "other");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("holds runs of another experiment or of other settings");
        assertThat(out.resolve("runs.csv")).hasContent("configuration");
    }

    @Test
    void faultsOfAnExperimentsFileAreNamedWithTheirPlaces() throws IOException {
        Path file = folder.resolve("mine.json");
        Files.writeString(file, """
            {"format": "crw-experiment", "version": 1, "id": "mine",
             "factors": {"boats": [2]},
             "versions": [{"name": "a", "start": [{"start": "clw"}, {"press": "alarm", "when": 3}, {"wait": "${pause}"}]}],
             "columns": [{"gain": "click", "of": "a", "against": "b"}]}
            """);

        CommandResult ran = crw("experiment", file.toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.err())
                .contains("mine.json:4")
                .contains("/columns/0/gain")
                .contains("A measure is time");
        Files.writeString(file, Files.readString(file).replace("\"click\"", "\"clicks\""));
        assertThat(crw("experiment", file.toString()).err())
                .contains("There is no plan \"clw\"")
                .contains("\"when\" is not known here")
                .contains("There is no setting, factor or derived value \"pause\"")
                .contains("There is no version \"b\"");
    }

    @Test
    void experimentOfOnesOwnRunsAndHasItsFactors() throws IOException {
        Path file = folder.resolve("mine.json");
        Files.writeString(file, """
            {"format": "crw-experiment", "version": 1, "id": "mine", "title": "Two boats or three",
             "settings": {"area": 100, "locations": 3}, "factors": {"boats": [2, 3]}, "configuration": ["boats"],
             "versions": [{"name": "visit", "start": [{"start": "clv"}]}],
             "columns": [{"title": "seconds", "mean": "time", "of": "visit"}]}
            """);

        CommandResult ran = crw("experiment", file.toString(), "--repetitions", "1", "--jobs", "1");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines().toList()).element(2).asString().matches("boats +seconds +n +failed +redrawn");
        assertThat(ran.out().lines().filter(line -> line.matches("[23] .*1 +0 +0")))
                .hasSize(2);
    }

    @Test
    void oneFactorAtATimeDiffersFromTheBaseInOneVariable() throws IOException {
        Path file = folder.resolve("mine.json");
        Files.writeString(file, """
            {"format": "crw-experiment", "version": 1, "id": "mine",
             "settings": {"area": 100, "locations": 2}, "factors": {"boats": [1, 2]}, "configuration": ["boats"],
             "sensitivity": {"area": [100, 80]},
             "versions": [{"name": "visit", "start": [{"start": "clv"}]}],
             "columns": [{"title": "seconds", "mean": "time", "of": "visit"}]}
            """);

        CommandResult ran = crw("experiment", file.toString(), "--sensitivity", "--repetitions", "1", "--jobs", "1");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines().filter(line -> line.matches(".* 1 +0 +0")))
                .extracting(line -> line.replaceFirst(" {2,}.*", ""))
                .containsExactly("1", "2", "1, area 80");
    }

    @Test
    void criterionOfAnEventThatThereIsNotIsNamed() throws IOException {
        Path file = folder.resolve("mine.json");
        Files.writeString(file, """
            {"format": "crw-experiment", "version": 1, "id": "mine", "factors": {"boats": [1]},
             "versions": [{"name": "visit", "start": [{"start": "clv"}],
              "optimize": [{"plan": "clv", "event": "gone", "criterion": "fast"}]}],
             "background": {"plan": "background-action"},
             "columns": [{"mean": "time", "of": "visit"}]}
            """);

        assertThat(crw("experiment", file.toString()).err())
                .contains("Plan clv has no output event \"gone\"")
                .contains("allocation is auction")
                .contains("There is no plan \"background-action\"");
    }

    @Test
    void tableThatThereIsNotIsRefused() {
        CommandResult ran = crw("experiment", "--table", "9.9");

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains("there is no table '9.9'; there are 7.1, 7.2");
    }
}
