package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.path.TurningCircle;

/** The places of a tour by how far along it they lie, in metres. */
final class TourPlaces {
    private final List<Coordinate> places;
    private final double[] alongM;
    private final double[] turnsTo; // what turns before each place cost, for each metre of a boat's radius

    TourPlaces(List<Coordinate> places) {
        this.places = List.copyOf(places);
        alongM = new double[places.size()];
        for (int i = 1; i < alongM.length; i++) {
            alongM[i] = alongM[i - 1] + places.get(i - 1).distance(places.get(i));
        }
        turnsTo = new double[places.size() + 1];
        for (int i = 0; i < alongM.length; i++) {
            turnsTo[i + 1] = turnsTo[i] + (i == 0 || i + 1 == alongM.length ? 0 : turnAt(i));
        }
    }

    private double turnAt(int index) {
        Coordinate from = places.get(index - 1);
        Coordinate at = places.get(index);
        Coordinate to = places.get(index + 1);
        return TurningCircle.perRadius(from.x, from.y, at.x, at.y, to.x, to.y);
    }

    /** What a boat drives in addition where the tour turns between two places, for each metre of its radius. */
    double turns(double fromM, double toM) {
        return Math.max(0, turnsTo[firstFrom(toM)] - turnsTo[firstBeyond(fromM)]);
    }

    /** The index of the first place that is so far along. */
    private int firstFrom(double metres) {
        int found = Arrays.binarySearch(alongM, metres);
        return found >= 0 ? found : -found - 1;
    }

    private int firstBeyond(double metres) {
        int found = Arrays.binarySearch(alongM, metres);
        return found >= 0 ? found + 1 : -found - 1;
    }

    double lengthM() {
        return alongM[alongM.length - 1];
    }

    /** The place so far along; its ends beyond them. */
    Coordinate at(double metres) {
        int found = Arrays.binarySearch(alongM, metres);
        if (found >= 0) {
            return places.get(found);
        }
        int next = -found - 1;
        if (next == 0 || next == alongM.length) {
            return places.get(next == 0 ? 0 : alongM.length - 1);
        }
        Coordinate from = places.get(next - 1);
        Coordinate to = places.get(next);
        double part = (metres - alongM[next - 1]) / (alongM[next] - alongM[next - 1]);
        return new Coordinate(from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part);
    }

    /** The places from one to another further along, with both. */
    List<Coordinate> between(double fromM, double toM) {
        List<Coordinate> between = new ArrayList<>(List.of(at(fromM)));
        for (int i = 0; i < alongM.length; i++) {
            if (alongM[i] > fromM && alongM[i] < toM) {
                between.add(places.get(i));
            }
        }
        between.add(at(toM));
        return between;
    }
}
