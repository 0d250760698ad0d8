package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Ways to exchange tokens of a net that are alike. */
final class TokenExchanges {
    private final List<PlanNetPlace> places;

    /** @param places what those of the net stand for */
    TokenExchanges(List<PlanNetPlace> places) {
        this.places = places;
    }

    /** For each two robots, or tasks that are made, next to each other: the place that each place is exchanged for. */
    List<int[]> of(List<String> robots, int madeTasks) {
        List<int[]> exchanges = new ArrayList<>();
        for (int i = 0; i + 1 < robots.size(); i++) {
            exchanges.add(exchange(robots.get(i), robots.get(i + 1)));
        }
        for (int i = 1; i < madeTasks; i++) {
            exchanges.add(exchange(
                    PlanToken.madeTask(i, "").label(),
                    PlanToken.madeTask(i + 1, "").label()));
        }
        return exchanges;
    }

    private int[] exchange(String one, String other) {
        int[] image = IntStream.range(0, places.size()).toArray();
        Map<String, Integer> ofOther = new HashMap<>();
        for (int i = 0; i < image.length; i++) {
            if (places.get(i).token().equals(other)) {
                ofOther.put(places.get(i).planPlace(), i);
            }
        }
        for (int i = 0; i < image.length; i++) {
            Integer target = ofOther.get(places.get(i).planPlace());
            if (places.get(i).token().equals(one) && target != null) {
                image[i] = target;
                image[target] = i;
            }
        }
        return image;
    }
}
