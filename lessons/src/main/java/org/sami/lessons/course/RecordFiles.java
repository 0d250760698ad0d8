package org.sami.lessons.course;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.SourceLocation;
import org.sami.spn.json.Reading;

/** Reads the files of a course as records, and collects what is wrong with them. */
final class RecordFiles {
    private static final String CODE = "E-LESSON";

    private final CourseFiles files;
    private final List<Finding> findings = new ArrayList<>();

    RecordFiles(CourseFiles files) {
        this.files = Objects.requireNonNull(files, "files");
    }

    /** What a file is called in messages. */
    String name(String file) {
        return files.name(file);
    }

    /** All that is wrong so far. */
    List<Finding> findings() {
        return findings;
    }

    /** Notes what is wrong with a file. */
    void found(List<Finding> wrong) {
        findings.addAll(wrong);
    }

    /** The record of a file; empty, with findings, where it cannot be read. */
    <T> Optional<T> record(String file, Class<T> type) {
        Optional<String> text = text(file);
        if (text.isEmpty()) {
            return Optional.empty();
        }
        Reading<T> read = LessonJson.read(files.name(file), text.get(), type);
        findings.addAll(read.findings());
        return read.result();
    }

    /** The records of a file; none, with findings, where it cannot be read. */
    <T> List<T> records(String file, Class<T> type) {
        Optional<String> text = text(file);
        if (text.isEmpty()) {
            return List.of();
        }
        Reading<List<T>> read = LessonJson.readList(files.name(file), text.get(), type);
        findings.addAll(read.findings());
        return read.result().orElse(List.of());
    }

    /** The text of a file; empty, with a finding, where it is not there or cannot be read. */
    Optional<String> text(String file) {
        try {
            Optional<String> text = files.text(file);
            if (text.isEmpty()) {
                problem(file, "there is no such file");
            }
            return text;
        } catch (IOException e) {
            problem(file, "it cannot be read: " + e.getMessage());
            return Optional.empty();
        }
    }

    /** Notes what is wrong with a file as a whole. */
    void problem(String file, String what) {
        findings.add(
                Finding.error(CODE, "", files.name(file) + ": " + what).at(new SourceLocation(files.name(file), 1, 1)));
    }
}
