package org.sami.spn.reference;

import java.util.Map;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.TextValue;

/**
 * Small random plans with a shared sub-mission: who enters its place joins it, and it returns them one by one or together. It may stand in the start place, be ended, run
 * another sub-mission, or be run by one that is started for each visit. Transitions wait for news of {@link ChildPlans#EVENTS}; those of one plan sometimes for the same. Now and then a
 * button takes robots out, or nobody enters. A function of the seed.
 */
final class SharedPlans {
    private static final int FIRST_OF_CHILD = 3;

    private final Dice dice;
    private final Dice button;

    private SharedPlans(long seed) {
        dice = new Dice(seed * 163 + 29);
        button = new Dice(seed * 167 + 31);
    }

    static Project project(long seed) {
        SharedPlans plans = new SharedPlans(seed);
        NetBuilder main = plans.main();
        NetBuilder child = plans.child();
        return NetBuilder.project(
                main.build(), child.build(), plans.grandchild().build());
    }

    private NetBuilder main() {
        NetBuilder net = new NetBuilder("main").start("p0").places("p1", "p2");
        if (dice.chance(40)) {
            net.end("p3");
        } else {
            net.places("p3");
        }
        String sub = dice.chance(20) ? "p0" : "p1";
        if (dice.chance(80)) {
            net.shared(sub, "child");
        } else {
            net.sub(sub, "child");
        }
        net.transition("t0", event(0));
        net.in("p0", "t0", dice.pick("relevant all", "relevant >= 1", "proxy >= 1", "generic >= 1", "always"));
        net.out("t0", "p1", dice.pick("take all relevant", "take all relevant", "take 1 proxy", "take all any"));
        if (dice.chance(15)) {
            net.out("t0", "p2", dice.pick("take all generic", "take all relevant", "always"));
        }
        int more = 1 + dice.below(2);
        for (int i = 1; i <= more; i++) {
            String t = "t" + i;
            if (dice.chance(20)) {
                net.transition(t);
            } else {
                net.transition(t, event(i));
            }
            String from = i == 1 || dice.chance(60) ? sub : "p2";
            net.in(from, t, wanting());
            if (dice.chance(20)) {
                net.in(dice.pick("p0", "p2"), t, dice.pick("proxy = 0", "always", "any = 0"));
            }
            String to = dice.pick("p0", "p2", "p2", "p3", "p1");
            net.out(t, to, moving());
            if (dice.chance(30)) {
                net.out(
                        t,
                        to.equals("p3") ? "p2" : "p3",
                        dice.pick("take all generic", "consume all relevant", "consume all proxy", "consume all sub"));
            }
            if (dice.chance(10)) {
                net.out(t, sub.equals(to) ? "p2" : sub, dice.pick("always", "take all generic"));
            }
        }
        if (button.chance(20)) {
            net.transition("stop")
                    .input("stop", "Interrupt", Map.of("interruptName", new TextValue(EngineMarkings.BUTTON)), Map.of())
                    .in(sub, "stop", button.pick("relevant >= 1", "always"))
                    .out("stop", button.pick("p0", "p2"), button.pick("take all relevant", "take 1 proxy"));
        }
        if (button.chance(20)) {
            net.transition("send", ChildPlans.EVENTS.get(2)).in("p0", "send", "any >= 1");
            net.out("send", sub.equals("p0") ? "p1" : sub, "always");
        }
        return net;
    }

    /** The transition's own, or now and then that of the first one of its plan. */
    private String event(int transition) {
        boolean isOfChild = transition >= FIRST_OF_CHILD;
        return ChildPlans.EVENTS.get(dice.chance(25) ? isOfChild ? FIRST_OF_CHILD : 0 : transition);
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
                "take 1 proxy",
                "take all any",
                "add all sub");
    }

    private NetBuilder child() {
        NetBuilder net = new NetBuilder("child").start("c0").places("c1").end("ce");
        boolean isEnded = dice.chance(30);
        if (isEnded) {
            net.endShared("cx");
        }
        boolean hasChild = dice.chance(30);
        String inner = dice.chance(30) ? "c0" : "c1";
        if (hasChild && dice.chance(50)) {
            net.sub(inner, "grandchild");
        } else if (hasChild) {
            net.shared(inner, "grandchild");
        }
        net.transition("u0", event(FIRST_OF_CHILD));
        net.in("c0", "u0", dice.pick("relevant all", "proxy >= 1", "proxy >= 2", "always"));
        net.out(
                "u0",
                isEnded && dice.chance(20) ? "cx" : dice.pick("c1", "c1", "ce"),
                hasChild && inner.equals("c0") ? "take all sub" : inside());
        if (dice.chance(75)) {
            if (dice.chance(20)) {
                net.transition("u1");
            } else {
                net.transition("u1", event(FIRST_OF_CHILD + 1));
            }
            String from = dice.pick("c0", "c1", "c1");
            net.in(from, "u1", dice.pick("relevant all", "proxy >= 1", "proxy = 0", "always"));
            net.out(
                    "u1",
                    isEnded && dice.chance(40) ? "cx" : dice.pick("ce", "ce", "ce", "c0"),
                    hasChild && inner.equals(from) ? "take all sub" : inside());
            if (dice.chance(30)) {
                net.in(from.equals("c0") ? "c1" : "c0", "u1", dice.pick("proxy = 0", "always"));
            }
            if (dice.chance(15)) {
                net.out("u1", "c1", dice.pick("take all generic", "consume all relevant"));
            }
        }
        return net;
    }

    private String inside() {
        return dice.pick(
                "take all relevant",
                "take all relevant",
                "take all proxy",
                "take all any",
                "take 1 proxy",
                "take all generic",
                "consume all relevant");
    }

    private NetBuilder grandchild() {
        NetBuilder net = new NetBuilder("grandchild").start("g0").end("ge");
        net.transition("v0", event(FIRST_OF_CHILD + 2));
        net.in("g0", "v0", dice.pick("relevant all", "proxy >= 1"));
        return net.out("v0", "ge", dice.pick("take all relevant", "take all proxy", "take 1 proxy"));
    }
}
