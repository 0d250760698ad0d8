package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.cli.CommandResult.crw;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code crw journal --statistics}: what the missions of each plan needed, of one journal and of several. */
class JournalStatisticsTest {
    private static final Pattern CLICKS = Pattern.compile("(?m)^ +clicks +(\\d+)");

    @TempDir
    static Path folder;

    private static String report = "";

    @BeforeAll
    static void makeJournals() throws IOException {
        report = run("day1.journal", "clv-interrupts", "--interrupt", "recharge:boat2@60");
        run("day2.journal", "clv");
        Files.writeString(folder.resolve("script"), """
                add sim 45.4,10.9
                wait boats 1 within 120
                start clv
                wait decision
                answer all
                wait decision
                answer 45.4001,10.9001;45.40012,10.9001
                wait decision
                answer 1
                wait ended within 120
                quit
                """);
        CommandResult session = crw("session", "--journal", path("session.journal"), "--script", path("script"));
        assertThat(session.exitCode()).as(session.out() + session.err()).isZero();
    }

    private static String run(String journal, String plan, String... more) {
        List<String> arguments = new ArrayList<>(List.of("run", plan, "--boats", "3", "--locations", "6"));
        arguments.addAll(List.of("--area", "150", "--speed", "max", "--journal", path(journal)));
        arguments.addAll(List.of(more));
        CommandResult ran = crw(arguments.toArray(new String[0]));
        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        return ran.out();
    }

    private static String path(String name) {
        return folder.resolve(name).toString();
    }

    private static JsonNode json(String... journals) throws IOException {
        List<String> arguments = new ArrayList<>(List.of("journal"));
        List.of(journals).forEach(journal -> arguments.add(path(journal)));
        arguments.addAll(List.of("--statistics", "--json"));
        CommandResult ran = crw(arguments.toArray(new String[0]));
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        return new ObjectMapper().readTree(ran.out());
    }

    private static JsonNode plan(JsonNode statistics, String id) {
        for (JsonNode plan : statistics.path("plans")) {
            if (plan.path("plan").asText().equals(id)) {
                return plan;
            }
        }
        throw new AssertionError("no plan " + id + " in " + statistics);
    }

    @Test
    void clicksAreThoseOfTheReportOfTheRunAndEachBelongsToAPlan() throws IOException {
        Matcher clicks = CLICKS.matcher(report);
        assertThat(clicks.find()).as(report).isTrue();

        JsonNode day = json("day1.journal");

        assertThat(day.path("clicks").asLong()).isEqualTo(Long.parseLong(clicks.group(1)));
        long sum = 0;
        for (JsonNode plan : day.path("plans")) {
            sum += plan.path("clicks").asLong();
        }
        assertThat(sum).isEqualTo(day.path("clicks").asLong());
        assertThat(plan(day, "clv-interrupts")
                        .path("interrupts")
                        .path("recharge")
                        .asInt())
                .isOne();
        assertThat(plan(day, "clv-interrupts").path("boats").asInt()).isEqualTo(3);
        assertThat(plan(day, "recharge").path("boats").asInt()).isOne();
    }

    @Test
    void journalsOfSeveralDaysAreAddedUp() throws IOException {
        JsonNode run = plan(json("day2.journal"), "clv");
        JsonNode session = plan(json("session.journal"), "clv");

        JsonNode all = json("day1.journal", "day2.journal", "session.journal");

        JsonNode both = plan(all, "clv");
        assertThat(all.path("journals").asInt()).isEqualTo(3);
        assertThat(both.path("runs").asInt()).isEqualTo(2);
        double first = run.path("totalSeconds").asDouble();
        double second = session.path("totalSeconds").asDouble();
        assertThat(both.path("leastSeconds").asDouble()).isEqualTo(Math.min(first, second));
        assertThat(both.path("mostSeconds").asDouble()).isEqualTo(Math.max(first, second));
        assertThat(both.path("clicks").asLong())
                .isEqualTo(run.path("clicks").asLong() + session.path("clicks").asLong());
        assertThat(both.path("distanceM").asDouble()).isPositive();
        assertThat(run.path("distanceM").isMissingNode())
                .as("no positions in a run's journal")
                .isTrue();
    }

    @Test
    void textHasARowForEachPlanAndCsvTheSame() {
        CommandResult text = crw("journal", path("day1.journal"), path("day2.journal"), "--statistics");
        CommandResult csv = crw("journal", path("day1.journal"), path("day2.journal"), "--statistics", "--csv");

        assertThat(text.out().lines().map(line -> line.replaceFirst(" .*", "")))
                .startsWith("plan", "clv", "clv-interrupts", "recharge", "");
        assertThat(text.out()).contains("2 journals", "3 missions started, 1 of them by other missions");
        assertThat(csv.out().lines().map(line -> line.replaceFirst(",.*", "")))
                .containsExactly("plan", "clv", "clv-interrupts", "recharge");
    }

    @Test
    void fileThatIsNoJournalIsNamedAndNothingIsPrinted() {
        CommandResult text = crw("journal", path("day1.journal"), path("script"), "--statistics");
        CommandResult none = crw("journal", path("day1.journal"), path("missing"), "--statistics");

        assertThat(text.exitCode()).isEqualTo(4);
        assertThat(text.err()).contains(path("script"), "no journal");
        assertThat(text.out()).isEmpty();
        assertThat(none.exitCode()).isEqualTo(2);
        assertThat(none.err()).contains("there is no journal " + path("missing"));
    }

    @Test
    void whatDoesNotGoTogetherIsRefused() {
        String day = path("day1.journal");

        assertThat(crw("journal", day, day).err()).contains("--statistics");
        assertThat(crw("journal", day, "--statistics", "--at", "1").exitCode()).isEqualTo(2);
        assertThat(crw("journal", day, "--statistics", "--json", "--csv").err()).contains("--json", "--csv");
        assertThat(crw("journal", day, "--json").err()).contains("--statistics");
    }
}
