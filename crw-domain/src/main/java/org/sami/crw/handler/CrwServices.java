package org.sami.crw.handler;

import java.util.Objects;
import org.sami.crw.service.allocation.AllocationService;
import org.sami.crw.service.assembly.AssemblyAlgorithm;
import org.sami.crw.service.assembly.HexagonalAssembly;
import org.sami.crw.service.coverage.CoverageAlgorithm;
import org.sami.crw.service.coverage.LawnMower;
import org.sami.crw.service.path.PathService;

/** The services that the handlers use. */
public record CrwServices(
        AllocationService allocation, PathService paths, AssemblyAlgorithm assembly, CoverageAlgorithm coverage) {
    /** All algorithms that there are. */
    public static final CrwServices STANDARD =
            new CrwServices(AllocationService.STANDARD, PathService.STANDARD, new HexagonalAssembly(), new LawnMower());

    public CrwServices {
        Objects.requireNonNull(allocation, "allocation");
        Objects.requireNonNull(paths, "paths");
        Objects.requireNonNull(assembly, "assembly");
        Objects.requireNonNull(coverage, "coverage");
    }
}
