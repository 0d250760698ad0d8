package org.sami.crw.service;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.sami.spn.value.GeoPoint;

/** Points and boats in a square of 600 m, seeded. */
public final class AreaOfTest {
    public static final GeoPoint CENTRE = GeoPoint.of(45.6, 10.68);

    private final Random random;

    /** An area of its own for each seed. */
    public AreaOfTest(long seed) {
        random = new Random(seed);
    }

    public GeoPoint point() {
        return Geodesy.offset(CENTRE, random.nextDouble() * 600 - 300, random.nextDouble() * 600 - 300);
    }

    public List<GeoPoint> points(int count) {
        return IntStream.range(0, count).mapToObj(i -> point()).toList();
    }

    public Map<String, GeoPoint> boats(int count) {
        Map<String, GeoPoint> boats = new LinkedHashMap<>();
        IntStream.rangeClosed(1, count).forEach(i -> boats.put("boat-" + i, point()));
        return boats;
    }
}
