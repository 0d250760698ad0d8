package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.cli.CommandResult.crw;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.run.ExperimentRuns;
import org.sami.crw.sim.experiment.ExperimentCase;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;

/** The command {@code crw experiment}. */
@Tag("long")
class ExperimentCommandTest {
    @TempDir
    Path folder;

    @Test
    void tableGoesToStandardOutputAndRowsOfRunsToTheFile() throws Exception {
        Path out = folder.resolve("rows.csv");

        CommandResult ran = crw(
                "experiment",
                "clv",
                "--area",
                "100",
                "--locations",
                "3",
                "--seeds",
                "1,5..6",
                "--conditions",
                "calm,field",
                "--out",
                out.toString());

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(ran.out().lines().toList()).hasSize(3);
        assertThat(ran.out().lines().toList().get(1)).matches("clv +calm +3 +3 .* 9/9 +9/9 .*");
        assertThat(ran.err())
                .contains("6 runs: missions 1, conditions 2, seeds 3;")
                .endsWith("6 of 6 runs ended\n");
        assertThat(Files.readAllLines(out)).hasSize(7).element(6).asString().startsWith("clv,field,6,ended,,0,");
    }

    /** Before boats held their place against a current and left edges that they came near to, they were 14.5 and 14.2 m inside with these seeds. */
    @Test
    void inRoughWaterBoatsThatGiveWayAmongRocksComeNoDeeperInsideThanWasAnnounced() {
        CommandResult ran = crw(
                "experiment",
                "../docs/experiments/rocks.json",
                "--plan",
                "explore-area",
                "--boats",
                "8",
                "--area",
                "200",
                "--at",
                "45.6988,10.72",
                "--interrupt",
                "Let somebody pass@60",
                "--seeds",
                "9,35",
                "--for",
                "1200",
                "--conditions",
                "rough",
                "--jobs",
                "2");

        assertThat(ran.out()).doesNotContain("deeper");
        assertThat(ran.exitCode()).as(ran.err()).isZero();
    }

    /** With this seed a boat waits for another that lies at its next waypoint, until its path is given up. */
    @Test
    void aMissionGoesOnWhileThePathOfABoatThatWaitsMayStillBeGivenUp() {
        CommandResult ran = crw(
                "experiment",
                "../docs/experiments/rocks.json",
                "--plan",
                "explore-area",
                "--boats",
                "12",
                "--area",
                "200",
                "--at",
                "45.6988,10.72",
                "--interrupt",
                "Let somebody pass@60",
                "--seeds",
                "34",
                "--for",
                "1800",
                "--conditions",
                "rough");

        assertThat(ran.err()).endsWith("1 of 1 runs ended\n");
        assertThat(ran.exitCode()).isZero();
    }

    @Test
    void missionsOfAFileRunWithFilesBesideIt() throws Exception {
        Files.writeString(folder.resolve("none.json"), """
            {"format": "crw-answers", "version": 1, "rules": [
             {"event": "OperatorCreateLocations", "answer": {"values": {"locations": []}}}]}\
            """);
        Path runs = Files.writeString(folder.resolve("my.runs"), """
            # two missions of one plan

            panorama --label nowhere --answers none.json
            clv --area 100 --locations 2 --for 20   # too short
            """);

        CommandResult ran =
                crw("experiment", "--runs", runs.toString(), "--seeds", "1", "--conditions", "calm", "--jobs", "2");

        assertThat(ran.out()).contains("nowhere  calm           1      1", "clv      calm           1      0");
        assertThat(ran.out()).contains("clv, calm, seed 1: running after 20 s");
        assertThat(ran.err()).endsWith("1 of 2 runs ended\n");
        assertThat(ran.exitCode()).isEqualTo(5);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "clv --boats 0            | my.runs:2: --boats is 1 to 250, not 0",
                "clv --seed 3             | my.runs:2: Unknown options: '--seed', '3'",
                "clv --set depth=3        | my.runs:2: --set: ",
                "clv --interrupt x@5      | my.runs:2: --interrupt: 'x@5': the plan has no interrupt 'x'",
                "clw                      | my.runs:2: there is no file and no plan of the library 'clw'",
                "--boats 3                | my.runs:2: Missing required parameter: 'PLAN|FILE'",
                "clv --answers none.json  | my.runs:2: --answers: cannot read none.json",
                "clv --interrupt 'x@5     | my.runs:2: a quote ' is not closed",
                "clv                      | my.runs:2: line 1 is called 'clv' already; give one of the two another"
                        + " name with --label"
            },
            quoteCharacter = '"')
    void lineThatMakesNoSenseIsNamed(String line, String told) throws Exception {
        Path runs = Files.writeString(folder.resolve("my.runs"), "clv\n" + line + "\n");

        CommandResult ran = crw("experiment", "--runs", runs.toString());

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.err()).contains(told);
        assertThat(ran.out()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "experiment                              | which missions? Name a plan (PLAN|FILE), or a file",
                "experiment clv --seeds 5..1             | seeds go from the smaller to the larger",
                "experiment clv --seeds 1..100000        | are at most 10000",
                "experiment clv --seeds few              | expected are seeds such as 1..20 or 3,7,11, not 'few'",
                "experiment clv --conditions storm       | storm",
                "experiment clv --jobs 0                 | --jobs is 1 to 1000, not 0",
                "experiment clv --runs x                 | --runs: the missions are those of x, and 'clv' is too many",
                "experiment --runs x --boats 3           | --boats: with --runs each line of x has its own options",
                "experiment --runs no-such.runs          | --runs: cannot read no-such.runs",
                "experiment clv --out no-such-folder/x   | --out: no-such-folder/x cannot be written",
                "experiment clv --overwrite              | --overwrite: there is no --out",
                "experiment clv --speed 3                | --speed"
            },
            quoteCharacter = '"')
    void wrongUsageIsNamed(String line, String told) {
        CommandResult ran = crw(line.strip().split(" +"));

        assertThat(ran.exitCode()).as(ran.err()).isEqualTo(2);
        assertThat(ran.err()).contains(told.strip()).doesNotContain("Exception");
        assertThat(ran.out()).isEmpty();
    }

    @Test
    void fileThatIsThereIsReplacedOnlyWhenAsked() throws Exception {
        Path out = Files.writeString(folder.resolve("rows.csv"), "precious");

        CommandResult refused = crw("experiment", "connect-boat", "--out", out.toString());
        assertThat(refused.exitCode()).isEqualTo(2);
        assertThat(out).hasContent("precious");

        CommandResult replaced = crw(
                "experiment",
                "connect-boat",
                "--seeds",
                "1",
                "--conditions",
                "calm",
                "--out",
                out.toString(),
                "--overwrite");
        assertThat(replaced.exitCode()).as(replaced.err()).isZero();
        assertThat(Files.readAllLines(out)).hasSize(2);
    }

    @Test
    void experimentOfTheLibraryHasEveryPlanThatPeopleStart() throws Exception {
        DomainLibrary library = PlanSource.library();
        Set<String> run = new TreeSet<>();
        for (ExperimentCase one : new ExperimentRuns(library).read(Path.of("../docs/experiments/library.runs"))) {
            run.add(one.plan().plan().id());
        }

        Set<String> children = library.plans().stream()
                .flatMap(plan -> plan.places().stream())
                .flatMap(place -> place.subMissions().stream())
                .map(subMission -> subMission.plan())
                .collect(Collectors.toSet());
        assertThat(run)
                .isEqualTo(library.plans().stream()
                        .map(Plan::id)
                        .filter(id -> !children.contains(id))
                        .collect(Collectors.toCollection(TreeSet::new)));
    }

    /** What is mended in the library is mended in the copies that lie among rocks. */
    @Test
    void plansAmongRocksAreThoseOfTheLibrary() throws Exception {
        DomainLibrary library = PlanSource.library();
        Path folder = Path.of("../docs/experiments");
        List<ExperimentCase> cases =
                new ArrayList<>(new ExperimentRuns(library).read(folder.resolve("separation.runs")));
        cases.addAll(new ExperimentRuns(library).read(folder.resolve("separation-areas.runs")));

        assertThat(cases).hasSize(26);
        Project rocks = new ProjectReader(library.vocabulary())
                .read(folder.resolve("rocks.json"))
                .orThrow();
        assertThat(rocks.globals()).extracting(VariableSpec::name).containsExactly("@noGo");
        for (Plan plan : rocks.plans()) {
            Plan original = library.projectOf(plan.id())
                    .flatMap(project -> project.plan(plan.id()))
                    .orElseThrow();
            assertThat(plan)
                    .as(plan.id())
                    .isEqualTo(original.withTestCases(List.of()).withQueries(List.of()));
        }
    }
}
