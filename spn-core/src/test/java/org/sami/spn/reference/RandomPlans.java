package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
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
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Small random projects: a plan {@code main} and plans that it may run as sub-missions. A function of the seed. */
final class RandomPlans {
    private static final String[] OUTPUTS = {
        "Do",
        "Do",
        "Do",
        "Do",
        "Approve",
        "ApproveThem",
        "Choose",
        "Pick",
        "Provide",
        "StartTimer",
        "StartProxyTimer",
        "GetAll",
        "GeneralInterrupt",
        "ProxyInterrupt",
        "ReturnValue"
    };
    private static final String[] IN = {
        "always", "always", "generic >= 1", "generic >= 1", "generic >= 2", "generic == 1", "generic = 0",
                "generic < 2",
        "proxy >= 1", "proxy >= 1", "proxy >= 2", "proxy = 0", "proxy < 2", "proxy == 1", "any >= 1", "any = 0",
        "any == 2", "any < 3", "task >= 1", "task = 0", "task == 1", "task:T1 >= 1", "task:Measure >= 1", "task:T1 = 0"
    };
    private static final String[] IN_RELEVANT = {
        "relevant all",
        "relevant all",
        "relevant >= 1",
        "relevant >= 1",
        "relevant >= 2",
        "relevant = 0",
        "relevant < 2",
        "relevant == 1"
    };
    private static final String[] OUT = {
        "take 1 generic",
        "take 1 generic",
        "take all generic",
        "take all proxy",
        "take 1 proxy",
        "take 2 proxy",
        "take all any",
        "take 1 any",
        "take all task",
        "take 1 task",
        "take 1 task:T1",
        "take all task:Measure",
        "consume 1 generic",
        "consume all generic",
        "consume 1 proxy",
        "consume all any",
        "consume 1 task",
        "add 1 generic",
        "add 2 generic",
        "add all generic",
        "add 1 proxy",
        "add all proxy",
        "add all any",
        "add 1 any",
        "add all task",
        "always"
    };
    private static final String[] OUT_RELEVANT = {
        "take all relevant",
        "take all relevant",
        "take all relevant",
        "take 1 relevant",
        "consume all relevant",
        "add all relevant"
    };
    private static final String[] OUT_SUB = {
        "take all sub", "take all sub", "take 1 sub", "add all sub", "consume all sub"
    };

    private final Random random;
    private final List<String> subMissionPlaces = new ArrayList<>();
    private final List<String> twoAtOnce = new ArrayList<>();
    private final Map<String, List<String>> outputsOf = new LinkedHashMap<>();

    private RandomPlans(Random random) {
        this.random = random;
    }

    static Project project(long seed) {
        Random random = new Random(seed);
        List<Plan> plans = new ArrayList<>();
        List<String> children = new ArrayList<>();
        boolean nested = random.nextInt(100) < 45;
        if (nested) {
            plans.add(new RandomPlans(random).plan("inner", List.of(), true));
            children.add("inner");
            if (random.nextInt(3) == 0) {
                plans.add(new RandomPlans(random).plan("middle", List.of("inner"), true));
                children.add("middle");
            }
        }
        plans.add(new RandomPlans(random).plan("main", children, false));
        VariableSpec global = new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(100)));
        return NetBuilder.project(List.of(global), plans.toArray(Plan[]::new));
    }

    // ---- Vertices

    private Plan plan(String id, List<String> children, boolean isChild) {
        NetBuilder net = new NetBuilder(id);
        int places = 3 + random.nextInt(isChild ? 3 : 6);
        int ends = chance(85) ? 1 + random.nextInt(2) : 0;
        net.start("p0");
        for (int i = 1; i < places; i++) {
            String place = "p" + i;
            if (i < places - ends) {
                net.places(place);
            } else if (isChild && chance(30)) {
                net.endShared(place);
            } else {
                net.end(place);
            }
        }
        net.variable("@own", ValueType.Simple.INTEGER, new IntegerValue(1));
        net.variable("@empty", ValueType.Simple.INTEGER);
        tasks(net, isChild);
        for (int i = 0; i < places; i++) {
            decorate(net, "p" + i, i >= places - ends, children, isChild);
        }
        int transitions = places - 1 + random.nextInt(places);
        for (int i = 0; i < transitions; i++) {
            transition(net, "t" + i, i, places, ends);
        }
        return net.build();
    }

    private void tasks(NetBuilder net, boolean isChild) {
        if (chance(isChild ? 15 : 35)) {
            net.task("T1", "Measure", Map.of("number", new IntegerValue(7)));
            if (chance(50)) {
                net.task("T2", "Look", Map.of("text", new TextValue("there")));
            }
        }
    }

    private void decorate(NetBuilder net, String place, boolean isEnd, List<String> children, boolean isChild) {
        outputsOf.put(place, new ArrayList<>());
        int outputs = chance(65) ? 1 : chance(25) ? 2 : 0;
        for (int i = 0; i < outputs; i++) {
            String type = pick(OUTPUTS);
            if (outputsOf.get(place).contains(type) || (isEnd && !type.equals("Do") && !type.equals("ReturnValue"))) {
                continue;
            }
            if (!isChild && chance(1)) {
                type = chance(50) ? "AbortMission" : "CompleteMission";
            }
            net.output(place, type, fields(type, isChild), writes(type), markups(type));
            outputsOf.get(place).add(type);
        }
        if (!isEnd && !children.isEmpty() && chance(35)) {
            String child = children.get(random.nextInt(children.size()));
            if (chance(35)) {
                net.shared(place, child);
            } else {
                Map<String, String> variables = chance(30) ? Map.of("@own", "@empty") : Map.of();
                net.sub(place, child, false, Map.of(), variables);
                if (chance(10)) {
                    net.sub(place, children.get(0), false, Map.of(), Map.of());
                    twoAtOnce.add(place);
                }
            }
            subMissionPlaces.add(place);
        }
    }

    private Map<String, FieldSource> fields(String type, boolean isChild) {
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        switch (type) {
            case "Do" -> {
                switch (random.nextInt(isChild ? 5 : 6)) {
                    case 0 -> fields.put("number", fixed(new IntegerValue(random.nextInt(9))));
                    case 1 -> fields.put("number", new FieldSource.FromVariable(variable()));
                    case 2 -> fields.put("number", new FieldSource.FromVariable(variable()));
                    case 3 -> {
                        fields.put("number", new FieldSource.FromTask());
                        fields.put("text", new FieldSource.FromTask());
                    }
                    case 5 -> fields.put("number", new FieldSource.Asked(Optional.of(new IntegerValue(5)), chance(70)));
                    default -> {}
                }
            }
            case "StartTimer", "StartProxyTimer" ->
                fields.put("duration", fixed(new DurationValue(1000L * (1 + random.nextInt(12)))));
            case "GeneralInterrupt", "ProxyInterrupt" -> fields.put("interruptName", fixed(new TextValue("stop")));
            case "ReturnValue" -> fields.put("value", fixed(new TextValue(chance(50) ? "good" : "bad")));
            case "Pick" -> fields.put("options", fixed(options()));
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

    private Map<String, String> writes(String type) {
        return type.equals("Do") && chance(15) ? Map.of("number", variable()) : Map.of();
    }

    private MarkupSpec[] markups(String type) {
        boolean decision = List.of("Approve", "ApproveThem", "Choose", "Pick").contains(type);
        if (!decision || chance(75)) {
            return new MarkupSpec[0];
        }
        boolean timer = chance(60);
        Map<String, Value> options = new LinkedHashMap<>();
        options.put("trigger", new EnumValue("Trigger", timer ? "TIMER" : "IMMEDIATELY"));
        if (timer) {
            options.put("timeout", new DurationValue(1000L * (1 + random.nextInt(9))));
        }
        return new MarkupSpec[] {new MarkupSpec("MixedInitiativeTrigger", options)};
    }

    // ---- Transitions

    private void transition(NetBuilder net, String t, int index, int places, int ends) {
        List<String> in = new ArrayList<>();
        int from = index < places - 1 - ends ? index : random.nextInt(Math.max(1, places - ends));
        boolean noInPlace = chance(3);
        if (!noInPlace) {
            in.add("p" + from);
            if (chance(35)) {
                String second = "p" + random.nextInt(places - ends);
                boolean bothRun = subMissionPlaces.contains(second) && subMissionPlaces.contains(in.get(0));
                if (!in.contains(second) && !bothRun) {
                    in.add(second);
                }
            }
        }
        List<String> events = noInPlace ? List.of(pick("News", "Interrupt")) : events(in);
        net.transition(t);
        events.forEach(event -> net.input(t, event, fixedFields(event), inputWrites(event)));
        boolean named = !events.isEmpty();
        if (named && chance(15)) {
            net.waitForAll(t);
        }
        for (String place : in) {
            boolean free = in.size() > 1 && chance(35);
            net.in(place, t, free ? new String[] {"always"} : inRequirements(named, subMissionPlaces.contains(place)));
        }
        outEdges(net, t, from, places, in, named, events.isEmpty());
    }

    private void outEdges(
            NetBuilder net, String t, int from, int places, List<String> in, boolean named, boolean eventless) {
        boolean fromSub = in.stream().anyMatch(subMissionPlaces::contains);
        int outs = chance(70) ? 1 : chance(70) ? 2 : 0;
        List<String> to = new ArrayList<>();
        for (int i = 0; i < outs; i++) {
            boolean forward = eventless ? chance(92) : chance(65);
            int target = forward ? from + 1 + random.nextInt(2) : random.nextInt(places);
            String place = "p" + Math.min(target, places - 1);
            if (!to.contains(place)) {
                to.add(place);
                net.out(t, place, outRequirements(named, fromSub));
            }
        }
    }

    private List<String> events(List<String> in) {
        List<String> answers = new ArrayList<>();
        for (String place : in) {
            outputsOf.get(place).forEach(type -> answers.addAll(answersTo(type)));
            if (subMissionPlaces.contains(place)) {
                answers.add("CheckReturn");
                if (!twoAtOnce.contains(place)) {
                    answers.add("SubMissionAborted");
                }
            }
        }
        if (chance(30)) {
            return List.of();
        }
        List<String> events = new ArrayList<>();
        if (!answers.isEmpty() && chance(80)) {
            events.add(answers.get(random.nextInt(answers.size())));
        } else {
            events.add(pick("News", "News", "Interrupt", "Pose", "AbortReceived", "CompleteReceived"));
        }
        if (chance(12)) {
            String second = answers.isEmpty() || chance(50) ? "Other" : answers.get(random.nextInt(answers.size()));
            if (!events.contains(second)) {
                events.add(second);
            }
        }
        return events;
    }

    private static List<String> answersTo(String type) {
        return switch (type) {
            case "Do" -> List.of("Done", "Done", "Done2");
            case "Approve" -> List.of("Yes", "No");
            case "ApproveThem" -> List.of("YesThem", "NoThem");
            case "Choose" -> List.of("Chosen");
            case "Pick" -> List.of("Picked", "PickedNone");
            case "Provide" -> List.of("Provided");
            case "StartTimer" -> List.of("TimerExpired");
            case "StartProxyTimer" -> List.of("ProxyTimerExpired");
            case "GetAll" -> List.of("GotAll");
            case "GeneralInterrupt" -> List.of("GeneralInterruptReceived");
            case "ProxyInterrupt" -> List.of("ProxyInterruptReceived");
            default -> List.of();
        };
    }

    private Map<String, Value> fixedFields(String event) {
        return switch (event) {
            case "Interrupt" -> Map.of("interruptName", new TextValue(pick("stop", "hold")));
            case "CheckReturn" -> Map.of("value", new TextValue(pick("good", "bad")));
            default -> Map.of();
        };
    }

    private Map<String, String> inputWrites(String event) {
        return switch (event) {
            case "Done", "Done2", "News", "Other" -> chance(35) ? Map.of("value", variable()) : Map.of();
            case "Provided" -> chance(60) ? Map.of("number", variable()) : Map.of();
            default -> Map.of();
        };
    }

    // ---- Requirements

    private String[] inRequirements(boolean named, boolean sub) {
        List<String> requirements = new ArrayList<>();
        int count = chance(90) ? 1 : 2;
        for (int i = 0; i < count; i++) {
            if (named && chance(40)) {
                requirements.add(pick(IN_RELEVANT));
            } else {
                requirements.add(sub && chance(50) ? "always" : pick(IN));
            }
        }
        return requirements.stream().distinct().toArray(String[]::new);
    }

    private String[] outRequirements(boolean named, boolean fromSub) {
        List<String> requirements = new ArrayList<>();
        int count = chance(70) ? 1 : 2;
        for (int i = 0; i < count; i++) {
            if (fromSub && chance(60)) {
                requirements.add(pick(OUT_SUB));
            } else if (named && chance(55)) {
                requirements.add(pick(OUT_RELEVANT));
            } else {
                requirements.add(pick(OUT));
            }
        }
        return requirements.stream().distinct().toArray(String[]::new);
    }

    private String variable() {
        return pick("@own", "@empty", "@global", "@undeclared");
    }

    private static FieldSource fixed(Value value) {
        return new FieldSource.Fixed(value);
    }

    private boolean chance(int percent) {
        return random.nextInt(100) < percent;
    }

    private String pick(String... choices) {
        return choices[random.nextInt(choices.length)];
    }
}
