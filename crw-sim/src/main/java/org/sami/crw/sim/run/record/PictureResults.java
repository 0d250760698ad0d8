package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.operator.picture.TakenPictures;
import org.sami.crw.report.PictureResult;
import org.sami.crw.report.PicturesPart;
import org.sami.session.record.PictureRows;
import org.sami.session.record.SessionPictures;
import org.sami.spn.journal.JournalAddress;
import org.sami.spn.journal.TelemetryRow;

/** The pictures of boats as a report has them. */
public final class PictureResults {
    private PictureResults() {}

    /** The part of a report; empty where none was fetched. */
    public static Optional<PicturesPart> part(List<PanoramaPictures> taken) {
        List<PictureResult> results = new ArrayList<>();
        for (PanoramaPictures each : taken) {
            each.pictures().forEach(picture -> results.add(result(each, picture)));
        }
        boolean kept = results.stream()
                .anyMatch(one -> one.file().isPresent() || !one.missed().isEmpty());
        return kept ? Optional.of(new PicturesPart(results)) : Optional.empty();
    }

    /** The same of the telemetry of a journal; next to a database no pictures are kept. */
    public static Optional<PicturesPart> part(JournalAddress journal, List<TelemetryRow> rows) {
        TakenPictures taken = new TakenPictures();
        SessionPictures pictures = journal.file().map(SessionPictures::besides).orElseGet(SessionPictures::temporary);
        new PictureRows(pictures).read(rows, taken::apply);
        return part(taken.all());
    }

    private static PictureResult result(PanoramaPictures of, BoatPicture picture) {
        return new PictureResult(
                of.atMillis(),
                of.boat(),
                of.mission(),
                picture.name(),
                of.from().latDeg(),
                of.from().lonDeg(),
                "pictures/" + SessionPictures.path(of.boat(), of.panorama(), picture.name()),
                picture.file(),
                picture.missed());
    }
}
