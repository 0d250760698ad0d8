package org.sami.crw.service.coverage;

import java.util.ArrayList;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;

/** A track cut into pieces of equal length. */
final class TrackPieces {
    private TrackPieces() {}

    /** The places of each piece, in order; each begins where the one before it ends. */
    static List<List<Coordinate>> of(List<Coordinate> track, int count) {
        double pieceM = lengthM(track) / count;
        List<List<Coordinate>> pieces = new ArrayList<>();
        List<Coordinate> piece = new ArrayList<>(List.of(track.get(0)));
        double drivenM = 0;
        for (int i = 1; i < track.size(); i++) {
            Coordinate from = track.get(i - 1);
            Coordinate to = track.get(i);
            double legM = from.distance(to);
            while (pieces.size() < count - 1 && drivenM + legM >= pieceM * (pieces.size() + 1)) {
                double part = legM == 0 ? 0 : (pieceM * (pieces.size() + 1) - drivenM) / legM;
                Coordinate cut = new Coordinate(from.x + (to.x - from.x) * part, from.y + (to.y - from.y) * part);
                piece.add(cut);
                pieces.add(piece);
                piece = new ArrayList<>(List.of(cut));
            }
            piece.add(to);
            drivenM += legM;
        }
        pieces.add(piece);
        return pieces;
    }

    /** The length of a track. */
    static double lengthM(List<Coordinate> track) {
        double lengthM = 0;
        for (int i = 1; i < track.size(); i++) {
            lengthM += track.get(i - 1).distance(track.get(i));
        }
        return lengthM;
    }
}
