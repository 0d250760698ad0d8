package org.sami.crw.report.file;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.report.DepthsPart;
import org.sami.crw.report.PicturesPart;
import org.sami.crw.report.ReportPart;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.picture.DepthPicture;
import org.sami.crw.report.picture.MapPicture;

/**
 * Writes a report's files into a folder: {@code report.json}, {@code boats.csv}, {@code locations.csv},
 * {@code approaches.csv}, {@code firings.csv}, {@code tracks.csv}, {@code readings.csv}, {@code decisions.csv}, {@code interrupts.csv}, {@code tasks.csv},
 * {@code messages.csv}, {@code phases.csv}, {@code operator.csv},
 * {@code run.gpx}, {@code run.kml}, {@code run.geojson} and {@code map.png}; where boats measured depths also {@code depths.csv} and {@code depths.png}; where they took pictures also {@code pictures.csv}, the page {@code pictures.html} and the folder
 * {@code pictures}. Files of those names are replaced; each appears whole or not at all.
 */
public final class ReportFolder {
    private static final List<String> FILES = List.of(
            "report.json",
            "boats.csv",
            "locations.csv",
            "approaches.csv",
            "firings.csv",
            "tracks.csv",
            "readings.csv",
            "decisions.csv",
            "interrupts.csv",
            "tasks.csv",
            "messages.csv",
            "phases.csv",
            "operator.csv",
            "run.gpx",
            "run.kml",
            "run.geojson",
            "map.png",
            "depths.csv",
            "depths.png",
            "pictures.csv",
            "pictures.html");

    private static final List<String> EXPORTED = List.of(
            "tracks.csv",
            "events.csv",
            "decisions.csv",
            "messages.csv",
            "readings.csv",
            "tasks.csv",
            "phases.csv",
            "operator.csv",
            "map.geojson",
            "depths.csv",
            "depths.png",
            "pictures.csv",
            "pictures.html");

    private final Path folder;

    /** A folder, which is made when something is written. */
    public ReportFolder(Path folder) {
        this.folder = Objects.requireNonNull(folder, "folder");
    }

    /** Makes the folder, and all else that must be ready before a signal can end the process. */
    public void prepare() throws IOException {
        Files.createDirectories(folder);
        MapPicture.prepare();
    }

    /** A file of an earlier report, or one that would be taken for it; empty where there is none. */
    public Optional<Path> earlier() {
        return FILES.stream().map(folder::resolve).filter(Files::exists).findFirst();
    }

    /** Writes all files of a report. */
    public void write(RunReport report) throws IOException {
        Files.createDirectories(folder);
        text("report.json", ReportJson.text(report));
        text("boats.csv", ReportTables.boats(report).toString());
        text("locations.csv", ReportTables.locations(report).toString());
        text("approaches.csv", ReportTables.approaches(report).toString());
        text("firings.csv", ReportTables.firings(report).toString());
        text("tracks.csv", ReportTables.tracks(report).toString());
        text("readings.csv", ReportTables.readings(report).toString());
        text("decisions.csv", ReportTables.decisions(report).toString());
        text("interrupts.csv", ReportTables.interrupts(report).toString());
        text("tasks.csv", ReportTables.tasks(report).toString());
        text("messages.csv", ReportTables.messages(report).toString());
        parts(report);
        text("run.gpx", GpxFile.text(report));
        text("run.kml", KmlFile.text(report));
        text("run.geojson", GeoJsonFile.text(report));
        bytes("map.png", new MapPicture(report).png());
    }

    /** A file of an earlier export; empty where there is none. */
    public Optional<Path> exported() {
        return EXPORTED.stream().map(folder::resolve).filter(Files::exists).findFirst();
    }

    /** Writes the tables and the map as GeoJSON, and nothing that is of one run alone. */
    public void export(RunReport report) throws IOException {
        Files.createDirectories(folder);
        text("tracks.csv", ReportTables.tracks(report).toString());
        text("events.csv", ReportTables.firings(report).toString());
        text("decisions.csv", ReportTables.decisions(report).toString());
        text("messages.csv", ReportTables.messages(report).toString());
        text("readings.csv", ReportTables.readings(report).toString());
        text("tasks.csv", ReportTables.tasks(report).toString());
        parts(report);
        text("map.geojson", GeoJsonFile.text(report));
    }

    private void parts(RunReport report) throws IOException {
        Optional<PicturesPart> pictures = report.part(PicturesPart.class);
        if (pictures.isPresent()) {
            text(
                    "pictures.html",
                    PictureFiles.copy(
                            pictures.get(), "Pictures of " + report.header().mission(), folder));
        }
        Optional<DepthsPart> depths = report.part(DepthsPart.class);
        if (depths.isPresent()) {
            bytes("depths.png", new DepthPicture(report, depths.get()).png());
        }
        for (ReportPart part : report.parts()) {
            text(part.name() + ".csv", ReportTables.of(part).toString());
        }
    }

    /** Where the picture is, once it is written. */
    public Path picture() {
        return folder.resolve("map.png");
    }

    private void text(String name, String content) throws IOException {
        bytes(name, content.getBytes(StandardCharsets.UTF_8));
    }

    private void bytes(String name, byte[] content) throws IOException {
        Path whole = folder.resolve(name + ".new");
        Files.write(whole, content);
        Files.move(whole, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
    }
}
