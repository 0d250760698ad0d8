package org.sami.crw.gui.decision;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.gui.SessionWorld;
import org.sami.spn.model.Project;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;

/** Plans that each ask the operator one thing, one for each component of the boats' domain, and what is done to answer them. */
final class AskedValues {
    /** A plan with two tasks, T1 and T2, which nobody does. */
    static final String TASKS = "tasks";

    private static final GeoPoint A = GeoPoint.of(45.1, 10.1);
    private static final GeoPoint B = GeoPoint.of(45.1, 10.2);
    private static final GeoPoint C = GeoPoint.of(45.2, 10.2);
    private static final TaskId FIRST = new TaskId(1, "T1");
    private static final TaskId SECOND = new TaskId(1, "T2");
    private static final Value ANNA = new ProxyValue("anna");
    private static final Value BERT = new ProxyValue("bert");

    private static final String WAY = "[{'lat': 45.1, 'lon': 10.1}, {'lat': 45.1, 'lon': %s}]";
    private static final String ALLOCATION = "{'paths': {'anna': " + WAY + "}, 'totalLengthM': %s, 'longestM': 7,"
            + " 'method': 'by hand', 'reason': 'as it was', 'unallocated': [], 'tasks': []}";
    private static final String PATHS = "{'paths': {'anna': " + WAY + "}, 'totalLengthM': 7, 'longestM': 7,"
            + " 'method': 'Safest path', 'kept': 'anna keeps 8.0 m where there is room, 5.2 m near 45.10000,10.15000'}";

    /**
     * One thing that is asked.
     *
     * @param id of the plan that asks it
     * @param type of the variable that has the answer then
     * @param components that are chosen for it, by their names
     * @param acts what is done to answer, a line each: {@code type FIELD TEXT}, {@code press BUTTON}, {@code choose BOX ENTRY}
     * @param given what the variable has then
     */
    record Asked(String id, String type, Set<String> components, List<String> acts, Value given) {
        String variable() {
            return "@" + id;
        }

        @Override
        public String toString() {
            return id + " of type " + type + " by " + components;
        }
    }

    static final List<Asked> ALL = List.of(
            one("note", "text", "TextField", new TextValue("on the way"), "type note-text on the way"),
            one("count", "integer", "NumberField", new IntegerValue(12), "type count-text 12"),
            one("spacing", "real", "NumberField", new RealValue(2.5), "type spacing-text 2.5"),
            one("pause", "duration", "DurationField", new DurationValue(90_000), "type pause-text 1 min 30 s"),
            one("calm", "boolean", "YesNoButtons", new BooleanValue(false), "press calm-no"),
            one("rank", "Rank", "ChoiceList", new EnumValue("Rank", "HIGH"), "press rank-option-3"),
            one("boat", "proxy", "ProxyList", BERT, "press boat-option-2"),
            one("boats", "list<proxy>", "ProxyList", new ListValue(List.of(ANNA, BERT)), "press boats-all"),
            one("job", "task", "TaskList", SECOND, "press job-option-2"),
            one("jobs", "list<task>", "TaskList", new ListValue(List.of(FIRST)), "press jobs-option-1"),
            one("spot", "point", "Map", A, "type spot-text 45.1, 10.1"),
            one("spots", "list<point>", "Map", new ListValue(List.of(A, B)), "type spots-text 45.1, 10.1 / 45.1, 10.2"),
            one("way", "path", "Map", new GeoPath(List.of(A, B)), "type way-text 45.1, 10.1 / 45.1, 10.2"),
            one("water", "area", "Map", area(), "type water-text 45.1, 10.1 / 45.1, 10.2 / 45.2, 10.2"),
            one(
                    "waters",
                    "list<area>",
                    "Map",
                    new ListValue(List.of(area())),
                    "type waters-text 45.1, 10.1 / 45.1, 10.2 / 45.2, 10.2"),
            one("which", "variable", "VariableList", new VariableReference("@note"), "press which-option-1"),
            one("plan", "plan", "PlanList", new PlanReference("note"), "press plan-option-1"),
            one(
                    "turns",
                    "map<task,proxy>",
                    "AllocationTable",
                    new MapValue(Map.of(SECOND, BERT)),
                    "choose turns-task-2 bert"),
            one(
                    "sensors",
                    "list<text>",
                    "TextField",
                    new ListValue(List.of(new TextValue("depth"))),
                    "press sensors-add",
                    "type sensors-1-text depth"),
            one("server", "BoatId", "TextField", boatId(), "type server-name-text zoe", "type server-server-text here"),
            new Asked(
                    "words",
                    "map<proxy,text>",
                    Set.of("ProxyList", "TextField"),
                    List.of("press words-add", "press words-1-key-option-1", "type words-1-value-text go"),
                    new MapValue(Map.of(ANNA, new TextValue("go")))),
            one("pager", "Allocation", "OptionPager", allocation(20), "press decision-next", "press decision-option-2"),
            one("tabs", "Allocation", "OptionTabs", allocation(20), "press decision-option-2"),
            one("stack", "Allocation", "OptionStack", allocation(10), "press decision-option-1"),
            one("ways", "map<proxy,path>", "OptionPager", paths(10.3), "press decision-option-2"),
            one("chosen", "variable", "VariableList", new VariableReference("@spots"), "press decision-option-1"));

    private AskedValues() {}

    private static Asked one(String id, String type, String component, Value given, String... acts) {
        return new Asked(id, type, Set.of(component), List.of(acts), given);
    }

    private static Value area() {
        return new GeoArea(List.of(A, B, C), List.of());
    }

    private static Value boatId() {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("name", new TextValue("zoe"));
        fields.put("color", new TextValue(""));
        fields.put("server", new TextValue("here"));
        fields.put("imageStorageDirectory", new TextValue(""));
        return new RecordValue("BoatId", fields);
    }

    private static Value paths(double lonDeg) {
        return new MapValue(Map.of(ANNA, new GeoPath(List.of(A, GeoPoint.of(45.1, lonDeg)))));
    }

    private static Value allocation(double totalM) {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put("paths", paths(10.2));
        fields.put("totalLengthM", new RealValue(totalM));
        fields.put("longestM", new RealValue(7));
        fields.put("method", new TextValue("by hand"));
        fields.put("reason", new TextValue("as it was"));
        fields.put("unallocated", new ListValue(List.of()));
        fields.put("tasks", new MapValue(Map.of()));
        return new RecordValue("Allocation", fields);
    }

    /** A project with all these plans, and those of the questions that have no value. */
    static Project project() {
        String globals = ALL.stream()
                .map(asked -> "{'name': '%s', 'type': '%s'}".formatted(asked.variable(), asked.type()))
                .collect(Collectors.joining(", "));
        Stream<String> ids =
                Stream.concat(ALL.stream().map(Asked::id), Stream.of("anything", "approve", "done", TASKS));
        Stream<String> plans = Stream.concat(
                ALL.stream().map(AskedValues::plan),
                Stream.of(
                        asking("anything", "DefineVariables", defined("@anything"), "", "DefinedVariablesReceived", ""),
                        asking("approve", "OperatorApprove", "", "", "YesOption", ""),
                        asking(
                                "done",
                                "OperatorBackgroundAction",
                                "'duration': {'value': 'PT1M'}",
                                "",
                                "OperatorBackgroundActionDone",
                                ""),
                        TASKS_PLAN));
        return SessionWorld.project("{'formatVersion': 1, 'id': 'asked', 'name': 'Asked', 'domain': 'crw', 'globals': ["
                + globals + ", {'name': '@anything', 'type': 'any'}],"
                + " 'missionTree': [{'label': 'All', 'children': ["
                + ids.map("{'plan': '%s'}"::formatted).collect(Collectors.joining(", ")) + "]}], 'plans': ["
                + plans.collect(Collectors.joining(", ")) + "]}");
    }

    private static final String TASKS_PLAN = """
            {'id': 'tasks', 'name': 'tasks', 'tasks': [
               {'name': 'T1', 'class': 'Temperature', 'fields': {'location': {'lat': 45.4, 'lon': 10.9}}},
               {'name': 'T2', 'class': 'Temperature', 'fields': {'location': {'lat': 45.4, 'lon': 10.8}}}],
             'places': [{'id': 'rest', 'name': 'Rest', 'start': true}],
             'transitions': [], 'inEdges': [], 'outEdges': []}""";

    private static String plan(Asked asked) {
        String allocations = "'options': {'value': [" + ALLOCATION.formatted("10.2", "10") + ", "
                + ALLOCATION.formatted("10.2", "20") + "]}";
        return switch (asked.id()) {
            case "pager", "tabs", "stack" ->
                asking(
                        asked.id(),
                        "OperatorAllocationOptions",
                        allocations,
                        format(asked.id()),
                        "OperatorAcceptedAllocation",
                        "'allocation': '%s'".formatted(asked.variable()));
            case "ways" ->
                asking(
                        asked.id(),
                        "OperatorPathOptions",
                        "'options': {'value': [%s, %s]}".formatted(PATHS.formatted("10.2"), PATHS.formatted("10.3")),
                        "",
                        "OperatorAcceptsPath",
                        "'paths': '%s'".formatted(asked.variable()));
            case "chosen" ->
                asking(
                        asked.id(),
                        "SelectVariable",
                        "'variableClass': {'value': 'list<point>'}",
                        "",
                        "VariableSelected",
                        "'variable': '%s'".formatted(asked.variable()));
            default ->
                asking(asked.id(), "DefineVariables", defined(asked.variable()), "", "DefinedVariablesReceived", "");
        };
    }

    private static String defined(String variable) {
        return "'variables': {'value': ['%s']}".formatted(variable);
    }

    private static String format(String id) {
        String format = Map.of("pager", "SEQUENTIAL", "tabs", "TABS", "stack", "STACKED")
                .get(id);
        return "{'type': 'SelectionOptions', 'options': {'number': 2, 'format': '%s'}}".formatted(format);
    }

    /** A plan that asks and ends with the answer. */
    private static String asking(String id, String output, String fields, String markup, String input, String writes) {
        boolean relevant =
                SessionWorld.LIBRARY.vocabulary().event(input).orElseThrow().tokens()
                        != org.sami.spn.vocabulary.TokenNeed.NONE;
        String kind = relevant ? "relevant" : "generic";
        return """
                {'id': '%1$s', 'name': '%1$s', 'places': [
                  {'id': 'ask', 'name': 'Ask', 'start': true, 'outputs': [
                    {'id': 'out', 'type': '%2$s', 'fields': {%3$s}, 'markups': [%4$s]}]},
                  {'id': 'end', 'name': 'End', 'end': true}],
                 'transitions': [{'id': 'when', 'inputs': [{'id': 'in', 'type': '%5$s', 'writes': {%6$s}}]}],
                 'inEdges': [{'id': 'a', 'place': 'ask', 'transition': 'when',
                   'requirements': [{'match': 'at-least', 'n': 1, 'kind': '%7$s'}]}],
                 'outEdges': [{'id': 'b', 'transition': 'when', 'place': 'end',
                   'requirements': [{'action': 'take', 'n': %8$s, 'kind': '%7$s'}]}]}""".formatted(id, output, fields, markup, input, writes, kind, relevant ? "'all'" : "1");
    }
}
