package org.sami.spn.reference;

import java.util.List;
import org.sami.spn.model.Project;
import org.sami.spn.testing.NetBuilder;

/** Small random plans in which every transition waits for news of a type of its own, or the only one fires at once. A function of the seed. */
final class NewsPlans {
    /** The types of news, one for each transition. */
    static final List<String> EVENTS = List.of("News", "Other", "Done", "Done2");

    private static final String[] PLACES = {"p0", "p1", "p2", "p3"};

    private final Dice dice;
    private final NetBuilder net = new NetBuilder("main");

    private NewsPlans(long seed) {
        dice = new Dice(seed * 131 + 17);
    }

    static Project project(long seed) {
        NewsPlans plans = new NewsPlans(seed);
        plans.draw();
        return NetBuilder.project(plans.net.build());
    }

    private void draw() {
        net.start("p0").places("p1", "p2");
        if (dice.chance(60)) {
            net.end("p3");
        } else {
            net.places("p3");
        }
        boolean firesAtOnce = dice.chance(20);
        int transitions = firesAtOnce ? 1 : 1 + dice.below(EVENTS.size());
        for (int i = 0; i < transitions; i++) {
            String t = "t" + i;
            if (firesAtOnce) {
                net.transition(t);
            } else {
                net.transition(t, EVENTS.get(i));
            }
            int from = i == 0 ? 0 : dice.below(3);
            net.in(PLACES[from], t, wanting());
            if (dice.chance(35)) {
                net.in(PLACES[(from + 1 + dice.below(2)) % 3], t, dice.chance(50) ? wanting() : inhibiting());
            }
            int to = (from + 1 + dice.below(3)) % PLACES.length;
            net.out(t, PLACES[to], moving());
            if (dice.chance(35)) {
                net.out(
                        t,
                        PLACES[(to + 1 + dice.below(2)) % PLACES.length],
                        dice.pick("consume all generic", "take all generic", "consume all relevant"));
            }
        }
    }

    private String wanting() {
        return dice.pick(
                "relevant all",
                "relevant all",
                "relevant >= 1",
                "proxy >= 1",
                "proxy >= 2",
                "proxy == 1",
                "generic >= 1",
                "any >= 2",
                "always");
    }

    private String inhibiting() {
        return dice.pick("proxy = 0", "generic = 0", "any = 0", "proxy < 2", "any < 3");
    }

    private String moving() {
        return dice.pick(
                "take all relevant",
                "take all relevant",
                "take all relevant",
                "take all proxy",
                "take all any",
                "take 1 generic",
                "consume all proxy",
                "consume 1 generic");
    }
}
