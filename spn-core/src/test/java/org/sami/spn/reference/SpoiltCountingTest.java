package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The comparison of counted with named robots notices when one line of what counts them, or of what names them in a run, is wrong: each row spoils one. */
class SpoiltCountingTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final int MOST_SEEDS = 500;
    private static final SpoiltNets NETS = new SpoiltNets(CountedJudge.class, MOST_SEEDS);

    /** What is spoilt, the class, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                option("who goes nowhere stands nowhere", ".filter(to -> !to.isEmpty())", ""),
                option("who only leaves stays", "left.isEmpty() && edges.isEmpty()", "edges.isEmpty()"),
                counted("robots at a place are one", "1, Integer::sum", "1, Integer::max"),
                counted("others may be there as well", "if (!isOneAnywhere) {", "if (false) {"),
                counted("nobody else may be there", "if (!isOneAnywhere) {", "if (true) {"),
                counted("robots need not be there", "arcs.atLeast(at(place), count)", "arcs.atLeast(at(place), 0)"),
                counted("robots do not move", "arcs.joinChanges(robot.arcs);", ""),
                counted(
                        "one more robot may be there",
                        "here.getOrDefault(place, 0) + 1)",
                        "here.getOrDefault(place, 0) + 2)"),
                counted("nobody may be where absent robots are not", "here.getOrDefault(place, 0) + 1)", "1)"),
                counted("places with a mission inside are watched", "!possible.hasSub(place)", "true"),
                counted(
                        "only places with a mission inside are watched",
                        "!possible.hasSub(place)",
                        "possible.hasSub(place)"),
                counted(
                        "where one may be anywhere nothing happens",
                        "if (isOneAnywhere && robots",
                        "if (isOneAnywhere || robots"),
                named("robots stand nowhere at first", "at.put(robot, counted.start())", "at.put(robot, Set.of())"),
                named("who may be anywhere has to be somewhere", "!option.isAnywhere", "true"),
                named("present robots stand anywhere", "standing.containsAll(option.present)", "true"),
                named(
                        "of who stands in several places one is enough",
                        ".map(standing::equals)",
                        ".map(all -> standing.containsAll(option.present))"),
                named("one robot does all", "used.add(robot);", ""),
                named("nobody is named", "if (option.isNamed) {", "if (false) {"),
                named("all are named", "if (option.isNamed) {", "if (true) {"),
                named("moves go backwards", "move.from(), move.to()));", "move.to(), move.from()));"),
                named("no move is told", "moves.add(new PlanNetMove(robot, move.from(), move.to()));", ""),
                named(
                        "robots stay where they were",
                        "to.put(robot, option.after(at.getOrDefault(robot, Set.of())));",
                        ""),
                named(
                        "robots go back to the start",
                        "at.putAll(to);",
                        "at.putAll(to); at.replaceAll((r, p) -> counted.start());"),
                named("tasks do not move", "all.addAll(moves);", "all.clear(); all.addAll(moves);"),
                named("tasks are not named", ".forEach(named::add)", ".forEach(token -> {})"),
                named("no end is told", "all, firing.ends()", "all, false"),
                named("tasks are nowhere", "if (!net.isRobot(token)) {", "if (false) {"),
                named("robots of the count are kept", "if (!net.isRobot(token)) {", "if (true) {"),
                profile("the start has no robots", "profile.equals(start) ? robots : 0", "0"),
                profile(
                        "robots keep their set of places",
                        "arcs.add(at(option.after(from)), 1)",
                        "arcs.add(at(from), 1)"),
                profile("robots stand in two sets of places", "moved.arcs.remove(at(from), 1);", ""),
                profile("robots need not be where they are taken", "standing.containsAll(option.present)", "true"),
                profile(
                        "robots may also be where they are not said to be",
                        "standing.contains(spot) == option.present.contains(spot)",
                        "true"),
                profile(
                        "no set of places is asked for",
                        "option.isAnywhere || (option.isStill",
                        "true || (option.isStill"),
                profile(
                        "who stays is not asked for the other places",
                        "boolean isCountedAtPlaces = watched <= 1 ||",
                        "boolean isCountedAtPlaces = true ||"),
                option("robots leave no place", "after.removeAll(left);", ""),
                option("robots leave all places", "after.removeAll(left);", "after.clear();"));
    }

    private static Arguments profile(String spoilt, String right, String wrong) {
        return arguments(spoilt, "RobotProfiles", right, wrong);
    }

    private static Arguments option(String spoilt, String right, String wrong) {
        return arguments(spoilt, "TokenOption", right, wrong);
    }

    private static Arguments counted(String spoilt, String right, String wrong) {
        return arguments(spoilt, "CountedRobots", right, wrong);
    }

    private static Arguments named(String spoilt, String right, String wrong) {
        return arguments(spoilt, "NamedRobots", right, wrong);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lines")
    void disagreesSoon(String spoilt, String source, String right, String wrong, @TempDir Path folder)
            throws ReflectiveOperationException {
        assertThat(NETS.difference(spoilt, folder, PLANS.resolve(source + ".java"), right, wrong))
                .as(spoilt)
                .isPresent();
    }
}
