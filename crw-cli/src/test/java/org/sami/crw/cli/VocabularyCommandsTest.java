package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** {@code crw events}, {@code crw markups}, and what {@code crw check} says of events that nobody knows or handles. */
class VocabularyCommandsTest {
    private static final ObjectMapper JSON = new ObjectMapper().enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

    @TempDir
    Path folder;

    private static Map<String, JsonNode> byName(CommandResult ran) throws Exception {
        assertThat(ran.exitCode()).isZero();
        JsonNode array = JSON.readTree(ran.out());
        assertThat(array.isArray()).isTrue();
        Map<String, JsonNode> found = new HashMap<>();
        array.forEach(node -> found.put(node.get("name").asText(), node));
        return found;
    }

    @Test
    void eventsIsOneArrayOfAllWithNamesFieldsAndAnswers() throws Exception {
        Map<String, JsonNode> events = byName(CommandResult.crw("events", "--json"));

        assertThat(events).hasSizeGreaterThan(76).containsKeys("TakePanorama", "TaskCompleted");
        JsonNode timer = events.get("StartSystemTimer");
        assertThat(timer.get("direction").asText()).isEqualTo("output");
        assertThat(timer.get("aliases").toString()).contains("\"StartTimer\"");
        assertThat(timer.get("fields").get(0).get("type").asText()).isEqualTo("duration");
        assertThat(timer.get("answers").toString()).isEqualTo("[\"TimerExpired\"]");
        assertThat(events.get("BatteryLow").get("causes").toString()).contains("BatteryLevelSubscription");
        assertThat(events.get("BatteryLow").get("fields").get(0).get("unit").asText())
                .isEqualTo("%");
    }

    @Test
    void eventsAsTextShowsOtherNamesFieldsAndAnswersOfThoseThatAreWanted() {
        CommandResult ran = CommandResult.crw("events", "startproxytimer");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .startsWith("StartProxyTimer  (output, on places)")
                .contains("also: ProxyStartTimer")
                .contains("duration (duration): How long it runs.")
                .contains("answers: ProxyTimerExpired")
                .doesNotContain("GetAllProxyTokens");
    }

    @Test
    void markupsIsOneArrayWithTheWordsOfEnumerations() throws Exception {
        Map<String, JsonNode> markups = byName(CommandResult.crw("markups", "--json"));

        assertThat(markups).hasSize(19);
        assertThat(markups.get("Sort").get("aliases").toString()).contains("SortOptions");
        assertThat(markups.get("Optimize")
                        .get("options")
                        .get(0)
                        .get("constants")
                        .toString())
                .contains("EXECUTION_TIME");
        assertThat(CommandResult.crw("markups", "optimize").out()).contains("criteria (COMPUTATION_TIME or ");
    }

    @Test
    void componentsExplainsAChoiceAndHowTheOthersDid() {
        CommandResult ran = CommandResult.crw(
                "components",
                "OperatorSelectBoatList",
                "--markup",
                "SortOptions.method=ALPHABETICAL",
                "--markup",
                "Filter");

        assertThat(ran.exitCode()).isZero();
        assertThat(ran.out())
                .startsWith("OperatorSelectBoatList: the operator sees")
                .contains("answer  list<proxy>")
                .contains("ProxyList with FilterBar; acts on Sort.method=ALPHABETICAL, Filter")
                .contains("2  ProxyList with FilterBar")
                .contains("0  Map with ProxyLayer")
                .contains("-1  unable: TextField");
        assertThat(CommandResult.crw("components", "--type", "list<BoatId>", "--create")
                        .out())
                .contains("for each element")
                .contains("server: TextField");
        assertThat(CommandResult.crw("components", "--type", "any").out())
                .contains("score -1")
                .contains("a warning: ");
        assertThat(CommandResult.crw("components").out()).contains("OptionTabs").contains("FilterBar  (widget)");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "OperatorSelectBoatLst",
                "OperatorApprove --markup Sotr",
                "OperatorApprove --markup Sort.by",
                "OperatorApprove --markup Sort.method=UP",
                "OperatorApprove --markup Filter.source=anna",
                "OperatorApprove --markup Sort..by",
                "--type pnt",
                "--create",
                "--markup Sort",
                "DefineVariables",
                "OperatorApprove --type point"
            })
    void componentsThatCannotBeChosenAreWrongUsage(String arguments) {
        CommandResult ran = CommandResult.crw(("components " + arguments).split(" "));

        assertThat(ran.exitCode()).isEqualTo(2);
        assertThat(ran.out()).isEmpty();
        assertThat(ran.err()).startsWith("crw: ");
    }

    @Test
    void phasesAreShownByActorWithTheEffectsOfABranch() {
        CommandResult first = CommandResult.crw("phases", "measure");
        CommandResult again = CommandResult.crw("phases", "measure", "--choose", "No");

        assertThat(first.exitCode()).isZero();
        assertThat(first.out())
                .startsWith("Get locations\n  OPERATOR  [Create locations]")
                .contains("Choose allocation: Yes (shown) | No\n  then Task execution\n")
                .contains("Task execution\n  PROXY  [Go to location]  [Measure]")
                .endsWith("then Task assignment\n\n");
        assertThat(again.out()).contains("Choose allocation: Yes | No (shown)").doesNotContain("[Yes]");
        assertThat(CommandResult.crw("phases", "clv").out()).contains("has no phases");
        assertThat(CommandResult.crw("phases", "measure", "--choose", "Perhaps").err())
                .isEqualTo("crw: --choose: no branch is called 'Perhaps'; there are Yes, No" + System.lineSeparator());
    }

    @Test
    void unknownNamesAreWrongUsageAndNearOnesAreOffered() {
        CommandResult events = CommandResult.crw("events", "StartTimmer");
        CommandResult markups = CommandResult.crw("markups", "Priorty");

        assertThat(events.exitCode()).isEqualTo(2);
        assertThat(events.err()).contains("StartTimer");
        assertThat(markups.exitCode()).isEqualTo(2);
        assertThat(markups.err()).contains("Priority");
    }

    @Test
    void checkOffersNamesForAnEventThatIsMisspelt() throws Exception {
        CommandResult ran = CommandResult.crw("check", plan("OperatorAproved").toString());

        assertThat(ran.exitCode()).isEqualTo(1);
        assertThat(ran.out()).contains("E-UNKNOWN-EVENT").contains("OperatorApprove meant?");
    }

    @Test
    void aPlanMayUseOtherNames() throws Exception {
        CommandResult ran =
                CommandResult.crw("check", plan("ProxyAddDescription").toString());

        assertThat(ran.out()).doesNotContain("E-UNKNOWN-EVENT");
    }

    private Path plan(String event) throws Exception {
        return Files.writeString(folder.resolve("plan.json"), """
                {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{"id": "p",
                 "places": [{"id": "a", "start": true, "outputs": [{"id": "e", "type": "%s"}]}],
                 "transitions": [], "inEdges": [], "outEdges": []}]}
                """.formatted(event));
    }
}
