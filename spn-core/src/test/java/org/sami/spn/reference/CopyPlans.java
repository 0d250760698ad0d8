package org.sami.spn.reference;

import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;

/** Small random plans that add robots to a second place while they stand in a first. Every transition waits for news of a type of its own. A function of the seed. */
final class CopyPlans {
    private static final String[] PLACES = {"p1", "p2", "p3", "p4"};
    private static final int LAST_SOURCE = 3;

    private final Dice dice;
    private final NetBuilder net = new NetBuilder("main");

    private CopyPlans(long seed) {
        dice = new Dice(seed * 137 + 29);
    }

    static Project project(long seed) {
        CopyPlans plans = new CopyPlans(seed);
        plans.draw();
        return NetBuilder.project(
                plans.net.build(), new NetBuilder("child").start("c").build());
    }

    private void draw() {
        net.start("p0").places("p1", "p2", "p3");
        if (dice.chance(60)) {
            net.end("p4");
        } else {
            net.places("p4");
        }
        boolean hasChild = dice.chance(40);
        if (hasChild) {
            net.sub("p3", "child");
        }
        net.transition("t0", NewsPlans.EVENTS.get(0));
        net.in("p0", "t0", dice.pick("relevant all", "relevant all", "relevant all", "relevant >= 1", "proxy >= 1"));
        net.out("t0", "p1", dice.pick("take all relevant", "take all relevant", "take all proxy", "take 1 relevant"));
        net.out("t0", "p2", dice.pick("add all relevant", "add all relevant", "take all relevant", "add all proxy"));
        int more = 1 + dice.below(NewsPlans.EVENTS.size() - 1);
        for (int i = 1; i <= more; i++) {
            String t = "t" + i;
            net.transition(t, NewsPlans.EVENTS.get(i));
            int from = dice.below(LAST_SOURCE);
            if (hasChild && dice.chance(40)) {
                net.in("p3", t, "proxy >= 1");
                net.out(t, dice.pick(PLACES), dice.pick("take all sub", "take all sub", "consume all sub"));
                continue;
            }
            if (dice.chance(10)) {
                net.in(PLACES[from], t, "relevant >= 1").in(PLACES[(from + 1) % LAST_SOURCE], t, "relevant = 0");
                net.out(t, "p4", "always");
                continue;
            }
            if (dice.chance(35)) {
                joins(t, from);
                continue;
            }
            net.in(
                    PLACES[from],
                    t,
                    dice.pick("relevant all", "relevant all", "relevant >= 1", "proxy >= 1", "proxy >= 2"));
            if (dice.chance(50)) {
                net.in(
                        PLACES[(from + 1) % LAST_SOURCE],
                        t,
                        dice.pick("always", "always", "proxy = 0", "relevant = 0", "relevant all"));
            }
            int to = dice.below(PLACES.length);
            net.out(t, PLACES[to], moving());
            if (dice.chance(40)) {
                net.out(
                        t,
                        PLACES[(to + 1) % PLACES.length],
                        dice.pick("consume all relevant", "consume 1 proxy", "add all relevant", "take all proxy"));
            }
        }
    }

    /** Takes one robot on, and with it the copies of it that stand in another place. */
    private void joins(String t, int from) {
        net.in(PLACES[from], t, dice.pick("relevant all", "relevant all", "relevant >= 1", "proxy >= 1"));
        net.in(PLACES[(from + 1 + dice.below(2)) % LAST_SOURCE], t, dice.pick("always", "always", "relevant >= 1"));
        String whom = dice.pick("relevant", "relevant", "proxy");
        net.out(t, PLACES[2 + dice.below(2)], "take 1 " + whom);
        if (dice.chance(75)) {
            net.out(t, "p4", dice.pick("consume all ", "consume all ", "consume 1 ") + whom);
        }
    }

    private String moving() {
        return dice.pick(
                "take all relevant",
                "take all relevant",
                "take 1 relevant",
                "take all proxy",
                "take 1 proxy",
                "take 2 relevant",
                "always",
                "take all sub",
                "take all any");
    }
}
