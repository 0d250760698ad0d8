package org.sami.spn.reference;

import java.util.List;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;

/**
 * Small random plans with a sub-mission that is started for each visit; its plan may run another one. Every transition waits for news of a type of its own, or the parent's
 * only one out of the place fires at once. A function of the seed.
 */
final class ChildPlans {
    /** The types of news, one for each transition: the parent's, then those of its descendants. */
    static final List<String> EVENTS = List.of("News", "Other", "Failed", "Done", "Done2", "Chosen");

    private static final int FIRST_OF_CHILD = 3;

    private final Dice dice;

    private ChildPlans(long seed) {
        dice = new Dice(seed * 149 + 41);
    }

    static Project project(long seed) {
        ChildPlans plans = new ChildPlans(seed);
        NetBuilder main = plans.main();
        NetBuilder child = plans.child();
        return NetBuilder.project(
                main.build(), child.build(), plans.grandchild().build());
    }

    private NetBuilder main() {
        NetBuilder net = new NetBuilder("main").start("p0").places("p1", "p2");
        if (dice.chance(50)) {
            net.end("p3");
        } else {
            net.places("p3");
        }
        String sub = dice.chance(10) ? "p0" : "p1";
        net.sub(sub, "child");
        net.transition("t0", EVENTS.get(0));
        net.in("p0", "t0", dice.pick("relevant all", "relevant >= 1", "proxy >= 1", "generic >= 1", "always"));
        net.out(
                "t0",
                "p1",
                dice.pick(
                        "take all relevant", "take all relevant", "take all proxy", "take all proxy", "take all any"));
        if (dice.chance(15)) {
            net.out("t0", "p2", dice.pick("take all generic", "take all relevant", "consume all proxy"));
        }
        int more = 1 + dice.below(2);
        for (int i = 1; i <= more; i++) {
            String t = "t" + i;
            net.transition(t, EVENTS.get(i));
            String from = i == 1 || dice.chance(60) ? "p1" : "p2";
            net.in(from, t, wanting());
            if (dice.chance(20)) {
                net.in(dice.pick("p0", "p2"), t, dice.pick("proxy = 0", "always", "any = 0"));
            }
            String to = dice.pick("p0", "p2", "p2", "p3", from.equals("p1") ? "p2" : "p1");
            net.out(t, to, moving());
            if (dice.chance(30)) {
                net.out(
                        t,
                        to.equals("p3") ? "p2" : "p3",
                        dice.pick("take all generic", "consume all relevant", "consume all proxy", "consume all sub"));
            }
        }
        return net;
    }

    private String wanting() {
        return dice.pick(
                "relevant all", "relevant >= 1", "proxy >= 1", "proxy >= 2", "proxy < 2", "any >= 1", "always");
    }

    private String moving() {
        return dice.pick(
                "take all sub",
                "take all sub",
                "take all sub",
                "take 1 sub",
                "consume all sub",
                "take all relevant",
                "take all proxy",
                "take all any",
                "add all sub");
    }

    private NetBuilder child() {
        NetBuilder net = new NetBuilder("child").start("c0").places("c1").end("ce");
        boolean hasChild = dice.chance(25);
        if (hasChild) {
            net.sub("c1", "grandchild");
        }
        net.transition("u0", EVENTS.get(FIRST_OF_CHILD));
        net.in("c0", "u0", dice.pick("relevant all", "proxy >= 1", "proxy >= 2", "always"));
        net.out("u0", dice.pick("c1", "c1", "ce"), inside());
        if (dice.chance(70)) {
            net.transition("u1", EVENTS.get(FIRST_OF_CHILD + 1));
            net.in("c1", "u1", dice.pick("relevant all", "proxy >= 1", "proxy = 0", "always"));
            net.out("u1", dice.pick("ce", "ce", "ce", "c0"), hasChild ? "take all sub" : inside());
            if (dice.chance(30)) {
                net.in("c0", "u1", dice.pick("proxy = 0", "always"));
            }
        }
        return net;
    }

    private String inside() {
        return dice.pick("take all relevant", "take all proxy", "take all any", "take 1 proxy", "consume all relevant");
    }

    private NetBuilder grandchild() {
        NetBuilder net = new NetBuilder("grandchild").start("g0").end("ge");
        net.transition("v0", EVENTS.get(FIRST_OF_CHILD + 2));
        net.in("g0", "v0", dice.pick("relevant all", "proxy >= 1"));
        return net.out("v0", "ge", inside());
    }
}
