package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.DoubleFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.sami.crw.service.water.Water;
import org.sami.session.api.Judgement.Remark;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Which of some places lie where boats may not go. */
final class PlaceRemarks {
    private static final int NAMED = 4;

    private PlaceRemarks() {}

    /** The remarks on places that an answer gives, in its order. */
    static List<Remark> of(List<GeoPoint> places, JudgedQuestion question) {
        List<Remark> remarks = new ArrayList<>();
        if (places.isEmpty()) {
            return remarks;
        }
        water(places.get(0), question.limits().avoid(), Optional.empty())
                .ifPresent(water -> remarks.addAll(of(
                        places,
                        water::depthM,
                        depth -> String.format(Locale.ROOT, "lies %.1f m inside %s", depth, question.avoidedOne()),
                        "lie in " + question.avoided())));
        question.stay()
                .ifPresent(fence -> water(places.get(0), List.of(), Optional.of(fence))
                        .ifPresent(water -> remarks.addAll(of(
                                places,
                                water::depthM,
                                depth -> String.format(
                                        Locale.ROOT, "lies %.1f m outside %s", depth, question.name(fence)),
                                "lie outside " + question.name(fence)))));
        return remarks;
    }

    private static Optional<Water> water(GeoPoint origin, List<GeoArea> avoid, Optional<GeoArea> within) {
        try {
            return Optional.of(Water.of(origin, avoid, within));
        } catch (IllegalArgumentException crossed) {
            return Optional.empty();
        }
    }

    private static List<Remark> of(
            List<GeoPoint> places, ToDoubleFunction<GeoPoint> depthM, DoubleFunction<String> one, String several) {
        List<Integer> wrong = new ArrayList<>();
        for (int i = 0; i < places.size(); i++) {
            if (depthM.applyAsDouble(places.get(i)) > 0) {
                wrong.add(i);
            }
        }
        if (wrong.isEmpty()) {
            return List.of();
        }
        if (wrong.size() == 1) {
            int place = wrong.get(0);
            String name = places.size() == 1 ? "The place" : "Place " + (place + 1) + " of " + places.size();
            return List.of(Remark.doubt(name + " " + one.apply(depthM.applyAsDouble(places.get(place)))));
        }
        String numbers =
                wrong.stream().limit(NAMED).map(i -> String.valueOf(i + 1)).collect(Collectors.joining(", "));
        return List.of(Remark.doubt(wrong.size() + " of " + places.size() + " places " + several + ": " + numbers
                + (wrong.size() > NAMED ? " and " + (wrong.size() - NAMED) + " more" : "")));
    }
}
