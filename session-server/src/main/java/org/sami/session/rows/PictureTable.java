package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.spn.protocol.Ids;

/** Rows of the pictures that boats took: which there are. The pictures themselves are fetched by HTTP. */
final class PictureTable {
    private static final int MOST = 100; // panoramas, the newest
    private static final int MOST_PICTURES = 40; // of a panorama

    private PictureTable() {}

    /** The table of pictures, of which the newest come last in the list and first by rank. */
    static Table of(List<PanoramaPictures> all) {
        Table.Builder table = new Table.Builder("pictures", MOST);
        for (int i = all.size() - 1; i >= Math.max(0, all.size() - MOST); i--) {
            int rank = table.size();
            PanoramaPictures one = all.get(i);
            ObjectNode row = table.row(one.boat() + "/" + one.panorama());
            row.put("rank", rank);
            row.put("boat", one.boat()).put("panorama", one.panorama());
            if (one.mission() != Ids.NONE) {
                row.put("mission", String.valueOf(one.mission()));
            }
            row.put("at", one.atMillis());
            row.put("lat", Shapes.rounded(one.from().latDeg()));
            row.put("lon", Shapes.rounded(one.from().lonDeg()));
            ArrayNode pictures = row.putArray("pictures");
            one.pictures().stream().limit(MOST_PICTURES).forEach(picture -> fill(pictures.addObject(), picture));
        }
        return table.build();
    }

    private static void fill(ObjectNode row, BoatPicture picture) {
        row.put("name", Table.Builder.cut(picture.name()));
        row.put("state", picture.file().isPresent() ? "here" : picture.isComing() ? "coming" : "missed");
        Table.Builder.put(row, "why", picture.missed());
    }
}
