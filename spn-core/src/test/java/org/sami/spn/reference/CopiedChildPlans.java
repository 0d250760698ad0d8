package org.sami.spn.reference;

import java.util.Map;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.TextValue;

/**
 * Small random plans that make copies of robots and have a sub-mission that is started for each visit: a copy stays elsewhere, or several copies of one robot come to the place
 * of the sub-mission, together or one after the other. Now and then an interrupt takes robots out, or nobody enters. Transitions wait for news of {@link ChildPlans#EVENTS}. A function of the
 * seed.
 */
final class CopiedChildPlans {
    private static final int FIRST_OF_CHILD = 3;

    private final Dice dice;

    private CopiedChildPlans(long seed) {
        dice = new Dice(seed * 157 + 59);
    }

    static Project project(long seed) {
        CopiedChildPlans plans = new CopiedChildPlans(seed);
        NetBuilder main = plans.main();
        NetBuilder child = plans.child();
        return NetBuilder.project(
                main.build(), child.build(), plans.grandchild().build());
    }

    private NetBuilder main() {
        NetBuilder net = new NetBuilder("main").start("p0").places("p1", "p2");
        if (dice.chance(30)) {
            net.end("p3");
        } else {
            net.places("p3");
        }
        String sub = dice.chance(85) ? "p1" : "p2";
        if (dice.chance(95)) {
            net.sub(sub, "child");
        } else {
            net.shared(sub, "child");
        }
        net.transition("t0", ChildPlans.EVENTS.get(0));
        net.in("p0", "t0", dice.pick("relevant all", "relevant all", "relevant >= 1", "proxy >= 1", "generic >= 1"));
        boolean gathers = dice.chance(40);
        if (gathers) {
            gather(net, sub);
        } else {
            net.out(
                    "t0",
                    "p1",
                    dice.pick(
                            "take all relevant",
                            "take all relevant",
                            "take 1 proxy",
                            "take all any",
                            "add all relevant"));
            net.out(
                    "t0",
                    "p2",
                    dice.pick("add all relevant", "add all relevant", "take all relevant", "add 1 relevant", "always"));
        }
        int more = gathers ? 1 : 1 + dice.below(2);
        for (int i = 1; i <= more; i++) {
            String t = "t" + i;
            if (dice.chance(15)) {
                net.transition(t);
            } else {
                net.transition(t, ChildPlans.EVENTS.get(i));
            }
            String from = i == 1 || dice.chance(50) ? sub : sub.equals("p1") ? "p2" : "p1";
            net.in(from, t, wanting());
            if (dice.chance(20)) {
                net.in(dice.pick("p0", "p2"), t, dice.pick("proxy = 0", "always", "always", "relevant >= 1"));
            }
            String to = dice.pick("p0", "p2", "p3", "p3", from.equals("p1") ? "p2" : "p1");
            net.out(t, to, from.equals(sub) ? returning() : moving());
            if (dice.chance(25)) {
                net.out(
                        t,
                        to.equals("p3") ? "p2" : "p3",
                        dice.pick("take all generic", "consume all relevant", "add all proxy", "consume all sub"));
            }
        }
        if (dice.chance(20)) {
            net.transition("send", ChildPlans.EVENTS.get(2)).in("p0", "send", "any >= 1");
            net.out("send", sub, dice.pick("always", "always", "take 1 generic"));
        }
        if (dice.chance(20)) {
            net.transition("stop")
                    .input("stop", "Interrupt", Map.of("interruptName", new TextValue(EngineMarkings.BUTTON)), Map.of())
                    .in(sub, "stop", dice.pick("relevant >= 1", "always"))
                    .out(
                            "stop",
                            dice.pick("p0", "p3"),
                            dice.pick("take all relevant", "take 1 proxy", "add all proxy"));
        }
        return net;
    }

    /** Several copies of a robot come to another place one by one, and go from there to the sub-mission together. */
    private void gather(NetBuilder net, String sub) {
        String from = sub.equals("p1") ? "p2" : "p1";
        net.out("t0", from, "add all relevant");
        net.transition("t2", ChildPlans.EVENTS.get(2));
        net.in(from, "t2", dice.pick("relevant all", "proxy >= 1"));
        net.out("t2", sub, dice.pick("take all relevant", "take all proxy"));
        if (dice.chance(50)) {
            net.transition("t3", dice.pick(ChildPlans.EVENTS.get(1), ChildPlans.EVENTS.get(2)));
            net.in(sub, "t3", dice.pick("proxy >= 1", "always"));
            net.out("t3", dice.pick("p0", "p3"), dice.pick("take all sub", "take 1 proxy"));
        }
    }

    private String wanting() {
        return dice.pick(
                "relevant all", "relevant >= 1", "proxy >= 1", "proxy >= 1", "proxy >= 2", "proxy < 2", "always");
    }

    private String returning() {
        return dice.pick(
                "take all sub",
                "take all sub",
                "take all sub",
                "take 1 sub",
                "consume all sub",
                "add all sub",
                "take all relevant",
                "take all proxy",
                "take 1 proxy");
    }

    private String moving() {
        return dice.pick(
                "take all relevant", "take all relevant", "take all proxy", "take 1 proxy", "add all relevant");
    }

    private NetBuilder child() {
        NetBuilder net = new NetBuilder("child").start("c0").places("c1").end("ce");
        boolean hasChild = dice.chance(20);
        if (hasChild) {
            net.sub("c1", "grandchild");
        }
        net.transition("u0", ChildPlans.EVENTS.get(FIRST_OF_CHILD));
        net.in("c0", "u0", dice.pick("relevant all", "proxy >= 1", "proxy >= 2", "proxy < 2", "always"));
        net.out("u0", dice.pick("c1", "c1", "ce"), inside());
        if (dice.chance(70)) {
            net.transition("u1", ChildPlans.EVENTS.get(FIRST_OF_CHILD + 1));
            net.in("c1", "u1", dice.pick("relevant all", "proxy >= 1", "proxy = 0", "always"));
            net.out("u1", dice.pick("ce", "ce", "ce", "c0"), hasChild ? "take all sub" : inside());
            if (dice.chance(30)) {
                net.in("c0", "u1", dice.pick("proxy = 0", "always"));
            }
        }
        return net;
    }

    private String inside() {
        return dice.pick(
                "take all relevant",
                "take all proxy",
                "take all any",
                "take 1 proxy",
                "consume 1 proxy",
                "add 1 proxy");
    }

    private NetBuilder grandchild() {
        NetBuilder net = new NetBuilder("grandchild").start("g0").end("ge");
        net.transition("v0", ChildPlans.EVENTS.get(FIRST_OF_CHILD + 2));
        net.in("g0", "v0", dice.pick("relevant all", "proxy >= 1"));
        return net.out("v0", "ge", dice.pick("take all relevant", "take all proxy", "take 1 proxy"));
    }
}
