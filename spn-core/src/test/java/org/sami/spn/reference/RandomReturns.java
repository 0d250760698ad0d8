package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Reserved;

/**
 * Random projects about returned values: boats are sent one by one or together to one to three sub-missions on a place, come back with a
 * value, and transitions check one or two of them, of any plan or of one. A function of the dice.
 */
final class RandomReturns {
    private static final List<String> CHILDREN = List.of("inner", "middle");
    private static final String WORK = "p1";

    private final Dice dice;

    private RandomReturns(Dice dice) {
        this.dice = dice;
    }

    static Project project(Dice dice) {
        RandomReturns random = new RandomReturns(dice);
        List<Plan> plans = new ArrayList<>();
        CHILDREN.forEach(child -> plans.add(random.child(child)));
        plans.add(random.main());
        VariableSpec global = new VariableSpec("@global", ValueType.Simple.INTEGER, Optional.of(new IntegerValue(100)));
        return NetBuilder.project(List.of(global), plans.toArray(Plan[]::new));
    }

    /** Who is done returns good, who is done otherwise returns bad, or nothing. */
    private Plan child(String id) {
        NetBuilder net = new NetBuilder(id).start("p0").output("p0", "Do").end("p1");
        if (dice.chance(15)) {
            net.endShared("p2");
        } else {
            net.end("p2");
        }
        returning(net, "p1", "good");
        if (dice.chance(80)) {
            returning(net, "p2", dice.chance(80) ? "bad" : "good");
        }
        net.transition("t0", "Done").in("p0", "t0", "relevant all").out("t0", "p1", "take all relevant");
        net.transition("t1", "Done2").in("p0", "t1", "relevant all").out("t1", "p2", "take all relevant");
        return net.build();
    }

    private static void returning(NetBuilder net, String place, String value) {
        net.output(place, "ReturnValue", Map.of("value", new FieldSource.Fixed(new TextValue(value))), Map.of());
    }

    private Plan main() {
        NetBuilder net = new NetBuilder("main").start("p0").places(WORK, "p2", "p3");
        net.transition("t0", "News").in("p0", "t0", "relevant all").out("t0", WORK, "take all relevant");
        boolean shared = dice.chance(60);
        int subMissions = dice.chance(50) ? 1 : 2 + dice.below(2);
        for (int i = 0; i < subMissions; i++) {
            net.sub(WORK, dice.pick(CHILDREN), shared, Map.of(), Map.of());
        }
        int checks = 1 + dice.below(2);
        for (int i = 1; i <= checks; i++) {
            check(net, "t" + i);
        }
        net.input("pull", "Interrupt", Map.of("interruptName", new TextValue("stop")), Map.of())
                .in(WORK, "pull", "relevant >= 1")
                .out("pull", dice.pick("p0", WORK, "p3"), "take all relevant");
        net.input("open", "Interrupt", Map.of("interruptName", new TextValue("hold")), Map.of())
                .out("open", "p2", "add 1 generic");
        net.transition("again", "Other").in("p3", "again", "relevant >= 1").out("again", "p0", "take all relevant");
        return net.build();
    }

    private void check(NetBuilder net, String t) {
        boolean isGood = dice.chance(50);
        net.input(t, "CheckReturn", checked(isGood ? "good" : "bad"), Map.of());
        if (dice.chance(60)) {
            net.input(t, "CheckReturn", checked(isGood == dice.chance(80) ? "bad" : "good"), Map.of());
        }
        net.in(WORK, t, dice.pick("always", "always", "proxy >= 1", "proxy >= 2"));
        boolean gated = dice.chance(30);
        if (gated) {
            net.in("p2", t, "generic >= 1");
        }
        String move = dice.pick("take all sub", "take all sub", "take 1 sub", "take all proxy", "consume all sub");
        net.out(t, dice.pick("p3", "p3", WORK), move);
        if (gated) {
            net.out(t, "p3", "take 1 generic");
        }
    }

    private Map<String, Value> checked(String value) {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put(Reserved.VALUE, new TextValue(value));
        if (dice.chance(40)) {
            fields.put(Reserved.SUB_MISSION, new PlanReference(dice.pick(CHILDREN)));
        }
        return fields;
    }
}
