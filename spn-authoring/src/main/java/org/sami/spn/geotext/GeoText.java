package org.sami.spn.geotext;

import java.util.List;
import org.sami.spn.value.GeoPoint;

/**
 * What a file says, before anybody says what it means: a bracket's content may be a path as well as an area.
 *
 * @param nesting how deep the brackets are: 0 is bare points, 1 one list of points, 2 a list of such lists
 * @param lists the lists of points; with nesting 0 and 1 there is one
 */
public record GeoText(int nesting, List<PointList> lists) {
    public GeoText {
        lists = List.copyOf(lists);
    }

    /**
     * Points in one bracket.
     *
     * @param line where it begins, from 1
     */
    public record PointList(int line, List<GeoPoint> points) {
        public PointList {
            points = List.copyOf(points);
        }
    }

    /** How many points there are in all. */
    public int points() {
        return lists.stream().mapToInt(list -> list.points().size()).sum();
    }

    /** In words, such as {@code a list of 2 lists of points}. */
    public String words() {
        int count = points();
        String points = count + (count == 1 ? " point" : " points");
        if (nesting == 0) {
            return points + " without brackets";
        }
        return nesting == 1 ? "a list of " + points : "a list of " + lists.size() + " lists of points";
    }
}
