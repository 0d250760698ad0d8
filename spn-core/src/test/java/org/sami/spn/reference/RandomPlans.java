package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/**
 * Small random projects: a plan {@code main} and plans that it may run as sub-missions. Most of them are drawn so that their
 * transitions can fire, some without any sense. A function of the seed.
 */
final class RandomPlans {
    private static final String[] OUTPUTS = {
        "Do",
        "Do",
        "Do",
        "Do",
        "Do",
        "Approve",
        "ApproveThem",
        "Choose",
        "ChooseSome",
        "Pick",
        "Provide",
        "StartTimer",
        "StartProxyTimer",
        "GetAll",
        "GeneralInterrupt",
        "ProxyInterrupt",
        "ReturnValue",
        "ApplyAllocation"
    };

    /** One plan in so many is about returned values. */
    private static final int RETURNS_EVERY = 10;

    private final Dice dice;
    /** For what narrows questions; of its own, so that the rest of a seed's plan does not depend on it. */
    private final Dice narrowing;

    /** For further static sub-missions on a place; of its own, too. */
    private final Dice sharing;

    private final Sketch sketch;
    private final List<String> children;
    private final NetBuilder net;
    private final boolean isNested;

    private RandomPlans(Dice dice, String id, List<String> children, boolean hasTasks) {
        this.dice = dice;
        this.children = children;
        this.net = new NetBuilder(id);
        boolean isChild = !id.equals("main");
        isNested = id.equals("inner");
        int places = 3 + dice.below(isChild ? 2 : 5);
        narrowing = new Dice(31L * id.hashCode() + places);
        sharing = new Dice(37L * id.hashCode() + 101L * places + narrowing.below(1000));
        int ends = dice.chance(isChild ? 95 : 80) ? 1 + dice.below(2) : 0;
        sketch = new Sketch(places, ends, isChild, children, hasTasks);
    }

    static Project project(long seed) {
        Dice dice = new Dice(seed);
        if (Math.floorMod(seed, RETURNS_EVERY) == 3) {
            return RandomReturns.project(dice);
        }
        List<Plan> plans = new ArrayList<>();
        List<String> children = new ArrayList<>();
        boolean hasTasks = dice.chance(60);
        if (dice.chance(60)) {
            plans.add(new RandomPlans(dice, "inner", List.of(), hasTasks).plan());
            children.add("inner");
            if (dice.chance(35)) {
                plans.add(new RandomPlans(dice, "middle", List.of("inner"), hasTasks).plan());
                children.add("middle");
            }
        }
        plans.add(new RandomPlans(dice, "main", children, hasTasks).plan());
        VariableSpec global = new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(100)));
        return NetBuilder.project(List.of(global), plans.toArray(Plan[]::new));
    }

    private Plan plan() {
        net.start(Sketch.name(0));
        for (int i = 1; i < sketch.places; i++) {
            String place = Sketch.name(i);
            if (!sketch.isEnd(i)) {
                net.places(place);
            } else if (sketch.isChild && dice.chance(25)) {
                net.endShared(place);
            } else {
                net.end(place);
            }
        }
        variables();
        tasks();
        for (int i = 0; i < sketch.places; i++) {
            outputs(Sketch.name(i), sketch.isEnd(i));
            if (!sketch.isEnd(i) && !children.isEmpty() && dice.chance(40)) {
                subMissions(Sketch.name(i));
            }
        }
        new RandomTransitions(dice, net, sketch).draw();
        return net.build();
    }

    /** {@code @parents} is declared by the outer plans only: what children write to it is theirs. */
    private void variables() {
        net.variable("@own", ValueType.Simple.INTEGER, new IntegerValue(1));
        net.variable("@empty", ValueType.Simple.INTEGER);
        if (!sketch.isChild || (!isNested && dice.chance(50))) {
            net.variable("@parents", ValueType.Simple.INTEGER, new IntegerValue(5));
        }
    }

    private void tasks() {
        if (sketch.hasTasks && dice.chance(sketch.isChild ? 30 : 90)) {
            net.task("T1", "Measure", Map.of("number", new IntegerValue(7)));
            if (dice.chance(50)) {
                net.task("T2", "Look", Map.of("text", new TextValue("there")));
            }
        }
    }

    // ---- Output events

    private void outputs(String place, boolean isEnd) {
        int outputs = dice.chance(70) ? 1 : dice.chance(30) ? 2 : 0;
        for (int i = 0; i < outputs; i++) {
            String type = isEnd ? dice.pick("Do", "ReturnValue", "ReturnValue") : dice.pick(OUTPUTS);
            if (sketch.isChild && dice.chance(15)) {
                type = "ReturnValue";
            }
            if (dice.chance(isEnd ? 8 : 1)) {
                type = dice.chance(70) ? "AbortMission" : "CompleteMission";
            }
            if (!sketch.outputs.get(place).contains(type)) {
                net.output(place, type, fields(type), writes(type), markups(type));
                sketch.outputs.get(place).add(type);
            }
        }
    }

    private Map<String, FieldSource> fields(String type) {
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        switch (type) {
            case "Do" -> {
                switch (dice.below(sketch.isChild ? 25 : 30)) {
                    case 0, 1, 2, 3, 4 -> fields.put("number", fixed(new IntegerValue(dice.below(9))));
                    case 5, 6, 7, 8, 9, 10, 11, 12, 13, 14 ->
                        fields.put("number", new FieldSource.FromVariable(variable(dice)));
                    case 15, 16, 17, 18, 19 -> {
                        fields.put("number", new FieldSource.FromTask());
                        fields.put("text", new FieldSource.FromTask());
                    }
                    case 20, 25, 26 ->
                        fields.put("number", new FieldSource.Asked(Optional.of(new IntegerValue(5)), dice.chance(70)));
                    default -> {}
                }
            }
            case "StartTimer", "StartProxyTimer" ->
                fields.put("duration", fixed(new DurationValue(1000L * (1 + dice.below(12)))));
            case "GeneralInterrupt", "ProxyInterrupt" -> fields.put("interruptName", fixed(new TextValue("stop")));
            case "ReturnValue" -> fields.put("value", fixed(new TextValue(dice.chance(60) ? "good" : "bad")));
            case "Pick" -> fields.put("options", fixed(options()));
            case "ApplyAllocation" -> fields.put("tasks", fixed(allocation()));
            default -> {}
        }
        return fields;
    }

    private static Value options() {
        List<Value> options = new ArrayList<>();
        for (String text : List.of("left", "right")) {
            options.add(new RecordValue("Choice", Map.of("text", new TextValue(text))));
        }
        return new ListValue(options);
    }

    /** Of tasks that are there, mostly, where the plan runs as the session's first mission. */
    private Value allocation() {
        Map<Value, Value> allocation = new LinkedHashMap<>();
        allocation.put(new TaskId(1, "T1"), new ProxyValue(dice.pick("A", "B")));
        if (dice.chance(40)) {
            allocation.put(new TaskId(1, "T2"), new ProxyValue(dice.pick("A", "C")));
        }
        return new MapValue(allocation);
    }

    private Map<String, String> writes(String type) {
        return type.equals("Do") && dice.chance(20) ? Map.of("number", variable(dice)) : Map.of();
    }

    private MarkupSpec[] markups(String type) {
        boolean decision = List.of("Approve", "ApproveThem", "Choose", "ChooseSome", "Pick")
                .contains(type);
        if (!decision) {
            return new MarkupSpec[0];
        }
        List<MarkupSpec> markups = new ArrayList<>();
        if (type.startsWith("Choose") && narrowing.chance(30)) {
            markups.add(new MarkupSpec(
                    "Filter",
                    Map.of(
                            "source",
                            new TextValue(narrowing.pick("a", "B", "shore", "WATER")),
                            "action",
                            new EnumValue("FilterAction", narrowing.pick("INCLUDE", "EXCLUDE")))));
        }
        if (type.startsWith("Choose") && narrowing.chance(20)) {
            markups.add(new MarkupSpec(
                    "DefaultSelection",
                    Map.of("selection", new EnumValue("SelectionDefault", narrowing.pick("ALL", "NONE")))));
        }
        if (!dice.chance(65)) {
            markups.add(trigger());
        }
        return markups.toArray(new MarkupSpec[0]);
    }

    private MarkupSpec trigger() {
        boolean timer = dice.chance(75);
        Map<String, Value> options = new LinkedHashMap<>();
        options.put("trigger", new EnumValue("Trigger", timer ? "TIMER" : "IMMEDIATELY"));
        if (timer) {
            options.put("timeout", new DurationValue(1000L * (1 + dice.below(9))));
        }
        return new MarkupSpec("MixedInitiativeTrigger", options);
    }

    // ---- Sub-missions

    private void subMissions(String place) {
        boolean isShared = dice.chance(40);
        subMission(place, dice.pick(children), isShared);
        if (dice.chance(12)) {
            subMission(place, children.get(0), isShared);
            sketch.twoAtOnce.add(place);
        }
        for (int more = 0; isShared && more < 2 && sharing.chance(45); more++) {
            net.sub(place, sharing.pick(children), true, Map.of(), Map.of());
        }
    }

    private void subMission(String place, String child, boolean isShared) {
        Map<String, String> tasks = dice.chance(40) ? Map.of("T1", dice.pick("T1", "T2", "C1")) : Map.of();
        Map<String, String> variables = Map.of();
        if (dice.chance(35)) {
            variables = dice.chance(50) ? Map.of("@own", "@empty") : Map.of("@mapped", "@parents");
        }
        net.sub(place, child, isShared, tasks, variables);
        (isShared ? sketch.shared : sketch.dynamic).add(place);
    }

    static String variable(Dice dice) {
        return dice.pick("@own", "@empty", "@global", "@parents", "@parents", "@mapped", "@undeclared");
    }

    private static FieldSource fixed(Value value) {
        return new FieldSource.Fixed(value);
    }
}
