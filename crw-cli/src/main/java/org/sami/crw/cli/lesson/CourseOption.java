package org.sami.crw.cli.lesson;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.output.UsageFault;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.course.CourseReader;
import org.sami.spn.json.Reading;
import picocli.CommandLine.Option;

/** The option {@code --course}: the course that is meant, the one that ships where nothing is said. */
public final class CourseOption {
    @Option(
            names = "--course",
            paramLabel = "FOLDER",
            description = "A course of your own: a folder with course.json. Without it the course that comes with crw.")
    private @Nullable Path folder;

    /** What could be read of it, with findings. */
    Reading<Course> read() {
        if (folder != null && !Files.isDirectory(folder)) {
            throw new UsageFault("--course: there is no folder '" + folder + "'");
        }
        return CourseReader.read(files(), PlanSource.library());
    }

    CourseFiles files() {
        return folder == null ? CourseFiles.SHIPPED : CourseFiles.in(folder);
    }
}
